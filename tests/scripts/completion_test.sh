#!/usr/bin/env bash
# Asks bash's completion what it offers: completion_test.sh BASH_COMPLETION ZSH_COMPLETION
set -euo pipefail
bash_completion=$(realpath "$1")
zsh_completion=$(realpath "$2")
source "$bash_completion"
compopt() { :; } # it works only while a shell completes
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT
mkdir folder
touch file.png

expect() { # WANTED WORD...: the last word is being completed
  local wanted=$1 offered
  shift
  COMP_WORDS=(fluidymation "$@")
  COMP_CWORD=$#
  COMPREPLY=()
  _fluidymation
  offered=${COMPREPLY[*]:-}
  [ "$offered" = "$wanted" ] || { echo "'$*' offers '$offered'; wanted '$wanted'" >&2; exit 1; }
}

(expect 'nonsense' --src-mas) 2>/dev/null && exit 1 # a wrong offer is found
expect '--src-mask-path' --src-mas
expect '--target-start --target-speed --target-scale' --target-s
expect 'standard crisp calm thesis paper' --preset ''
expect 'thesis' --preset = th
expect 'standard crisp calm thesis paper' --preset =
expect 'file.png' --src-path fi
expect 'layers' la
expect 'file.png folder' layers ''
expect '--resume' layers --resu
expect 'file.png folder' --verify ''
expect 'folder' --dump-guides ''
expect '' --seed ''
expect '--version' --quiet --vers
expect '--help' --threads 3 --he

! command -v zsh >/dev/null || zsh -n "$zsh_completion"
