#!/usr/bin/env bash
# Builds the Debian packages, installs them, runs what they hold, removes them and looks for what is left.
# Usage: scripts/test_package.sh [--chroot]
#   --chroot   in a fresh Debian 12 (about 150 MB are downloaded), where nothing but the packages' own
#              dependencies is installed; else on this machine
# For root, in a container or on a machine for tests.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/common.sh
fresh=
if [ "${1:-}" = --chroot ]; then
  fresh=yes
  shift
fi
take_no_options "$@"
[ $# -eq 0 ] || refuse "$# arguments; wanted none"
[ "$(id -u)" -eq 0 ] || refuse "wanted root, to install packages"

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
scripts/package.sh "$work/packages"
mkdir -p "$work/tree"
cp "$work/packages"/*.deb "$work/tree"
# What is painted, where the packages are tried: a fresh Debian knows no clone.
mkdir -p "$work/tree/samples"
cp -r samples/source/rust samples/target-mask/jump "$work/tree/samples"
cp -r tests/scripts/consumer "$work/tree"

cat >"$work/tree/try.sh" <<'EOF'
set -eux
cd "$1"
export DEBIAN_FRONTEND=noninteractive
ls -l *.deb
apt-get update -qq
apt-get install -y -qq --no-install-recommends ./fluidymation_*.deb >apt.log 2>&1 || { cat apt.log; exit 1; }
command -v fluidymation
fluidymation --version
fluidymation --src-path samples/rust/rgb/%05d.png --src-mask-path samples/rust/mask/%05d.png \
  --target-path samples/jump/%05d.png --target-frames 3 --out-path painted/%05d.png --quiet
fluidymation --verify painted/fluidymation.json
(cd painted && sha256sum 0*.png fluidymation.json) >digests
test -s /usr/share/bash-completion/completions/fluidymation
grep -q '^#compdef fluidymation' /usr/share/zsh/vendor-completions/_fluidymation
# Debian's slim images leave documents away
test -e /usr/share/man/man1/fluidymation.1 || test -n "$(ls /etc/dpkg/dpkg.cfg.d/* 2>/dev/null)"

apt-get install -y -qq --no-install-recommends ./libfluidymation-dev_*.deb cmake g++ make >apt.log 2>&1 || { cat apt.log; exit 1; }
cmake -S consumer -B consumer-build >/dev/null
cmake --build consumer-build >/dev/null
consumer-build/consumer

dpkg --purge libfluidymation-dev fluidymation
for left in /usr/bin/fluidymation /usr/include/fluidymation /usr/lib/*/libfluidymation.a \
  /usr/lib/*/cmake/fluidymation /usr/share/doc/fluidymation /usr/share/man/man1/fluidymation.1; do
  test ! -e "$left"
done
EOF

dpkg-deb --info "$work/tree"/fluidymation_*.deb
dpkg-deb --contents "$work/tree"/fluidymation_*.deb
if [ -n "$fresh" ]; then
  scripts/install_packages.sh chroot
  mmdebstrap --variant=apt bookworm "$work/debian"
  mv "$work/tree" "$work/debian/opt/try"
  chroot "$work/debian" sh /opt/try/try.sh /opt/try
  digests=$work/debian/opt/try/digests
else
  sh "$work/tree/try.sh" "$work/tree"
  digests=$work/tree/digests
fi

# The same frames as from this clone's build.
mkdir "$work/samples"
cp -r samples/source/rust samples/target-mask/jump "$work/samples"
(
  tool=$PWD/build/release/fluidymation
  cd "$work"
  "$tool" --src-path samples/rust/rgb/%05d.png --src-mask-path samples/rust/mask/%05d.png \
    --target-path samples/jump/%05d.png --target-frames 3 --out-path painted/%05d.png --quiet
  cd painted && sha256sum 0*.png fluidymation.json
) | diff - "$digests"
echo "the packages install, paint the same bytes, link, and leave nothing"
