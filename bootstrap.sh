#!/usr/bin/env bash
# Installs what wristwise needs on Debian 12, configures and builds it in build/.
#   ./bootstrap.sh          the program and the library
#   ./bootstrap.sh tests    the tests as well
set -euo pipefail
cd "$(dirname "$0")"

packages=(build-essential cmake ninja-build libeigen3-dev libceres-dev libfcl-dev
  liburdfdom-dev libtinyxml-dev libassimp-dev libqhull-dev libyaml-cpp-dev nlohmann-json3-dev
  libcli11-dev libfmt-dev libnlopt-cxx-dev zlib1g-dev)
with_tests=OFF
if [ "${1:-}" = tests ]; then
  packages+=(libgtest-dev libbullet-dev libbenchmark-dev chromium chromium-driver python3-selenium
    pybind11-dev python3-dev python3-numpy python3-pytest python3-mypy
    pkg-config lintian python3-jsonschema python3-yaml doxygen)
  with_tests=ON
fi

if ! dpkg-query -W -f '${Status}\n' "${packages[@]}" 2>/dev/null | grep -vq 'install ok installed' &&
  dpkg-query -W "${packages[@]}" >/dev/null 2>&1; then
  echo "Debian packages: all there"
else
  as_root=()
  [ "$(id -u)" = 0 ] || as_root=(sudo)
  export DEBIAN_FRONTEND=noninteractive
  "${as_root[@]}" apt-get update -qq
  "${as_root[@]}" apt-get install -y -qq --no-install-recommends "${packages[@]}" >/dev/null
fi

cmake -S . -B build -G Ninja -DWRISTWISE_BUILD_TESTS=$with_tests
cmake --build build
