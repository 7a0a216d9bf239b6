# What the scripts share; to be sourced by them from the project's folder.
# shellcheck shell=bash

samples_source=samples/source
samples_target=samples/target-mask

# The comment at the top of the calling script, from its second line on.
usage() { sed -n '2,/^[^#]/{s/^# \{0,1\}//p}' "$0"; }

# Wrong usage: one line, exit code 2.
refuse() {
  echo "$(basename "$0"): $*" >&2
  exit 2
}

# For scripts that have no option but --help.
take_no_options() { # ARGUMENT...
  case ${1:-} in
    -h | --help)
      usage
      exit 0
      ;;
    -*) refuse "$1: no such option; see --help" ;;
  esac
}

# Names of the sample exemplars and targets, one a line; the layers of a target as FOLDER/LAYER.
exemplar_names() { (cd "$samples_source" && for f in */rgb; do echo "${f%/rgb}"; done); }
target_names() {
  (cd "$samples_target" && for f in */00001.png */*/00001.png; do echo "${f%/00001.png}"; done)
}

# Here-strings, not pipes: grep -q ends before its writer, which pipefail would count as a failure.
require_exemplar() { # NAME
  grep -qxF -- "$1" <<<"$(exemplar_names)" ||
    refuse "$1: no such exemplar; there are: $(exemplar_names | paste -sd ' ')"
}

require_target() { # NAME
  grep -qxF -- "$1" <<<"$(target_names)" ||
    refuse "$1: no such target; there are: $(target_names | paste -sd ' ')"
}

require_frames() { # NUMBER
  [[ $1 =~ ^[1-9][0-9]{0,5}$ ]] || refuse "$1: wanted a number of frames from 1 to 999999"
}

# build/ and output/ as somebody else, perhaps root, has left them: CMake's own words would mislead.
require_own_folders() {
  local me folder
  me=$(id -un)
  folder=$(find build output -maxdepth 3 -type d ! -writable -print -quit 2>/dev/null || true)
  [ -n "$folder" ] || return 0
  echo "$(basename "$0"): $folder/ belongs to $(stat -c %U "$folder"), $me cannot write there;" \
    "remove it, or make it yours: sudo chown -R $me ${folder%%/*}" >&2
  exit 1
}

# One option and its value a line; empty lines and lines that begin with # do not count.
parameters_of() { # EXEMPLAR
  grep -vE '^\s*(#|$)' "$samples_source/$1/parameters.txt" | tr -s ' ' '\n'
}
