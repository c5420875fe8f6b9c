#!/usr/bin/env bash
# debian_packages.sh CASE SOURCE BUILD FOLDER: what `cpack` packs into FOLDER. Skipped (77) where a
# tool is missing.
set -euo pipefail
build=$3 folder=$4

fail() {
  echo "$*" >&2
  exit 1
}

needs() { command -v "$1" >/dev/null || exit 77; }

make() {
  needs dpkg-shlibdeps
  rm -rf "$folder"
  mkdir -p "$folder"
  cd "$folder"
  cpack -G DEB --config "$build/CPackConfig.cmake" -B "$folder"
}

version() { "$build/wristwise" --version | cut -d' ' -f2; }
library() { echo "libwristwise$(version | cut -d. -f1,2)"; }
package() { find "$folder" -maxdepth 1 -name "$1_*.deb"; }
field() { dpkg-deb -f "$(package "$1")" "$2"; }

names() {
  local name description
  for name in wristwise "$(library)" libwristwise-dev; do
    [ "$(field "$name" Package) $(field "$name" Version)" = "$name $(version)" ]
    description=$(field "$name" Description)
    grep '^planner for arc-welding robots' <<<"${description%%$'\n'*}"
  done
  [ "$(find "$folder" -maxdepth 1 -name '*.deb' | wc -l)" = 3 ]
}

# holds PACKAGE PATTERN...: of each there is a file
holds() {
  local name=$1 files pattern
  files=$(dpkg-deb -c "$(package "$name")" | awk '{print $6}')
  for pattern in "${@:2}" "usr/share/doc/$name/copyright" "usr/share/doc/$name/changelog.gz"; do
    grep -qE "^\./$pattern\$" <<<"$files" || fail "$name has no $pattern"
  done
}

contents() {
  holds wristwise usr/bin/wristwise usr/share/wristwise/problem-file.schema.json \
    usr/share/wristwise/problems/task_c_wrist_singularity.yaml \
    usr/share/wristwise/robots/kuka_kr5_arc/kuka_kr5_arc.urdf \
    usr/share/bash-completion/completions/wristwise usr/share/man/man1/wristwise.1.gz \
    usr/share/doc/wristwise/install.md
  holds "$(library)" "usr/lib/.*libwristwise\.so\.$(version)" \
    "usr/lib/.*libwristwise\.so\.$(version | cut -d. -f1,2)"
  holds libwristwise-dev usr/include/wristwise/wristwise.hpp usr/include/wristwise/version.hpp \
    'usr/lib/.*libwristwise\.so' 'usr/lib/.*libwristwise\.a' \
    'usr/lib/.*cmake/wristwise/wristwiseConfig.cmake' 'usr/lib/.*pkgconfig/wristwise.pc' \
    usr/share/doc/wristwise/examples/01_plan_a_seam.cpp \
    usr/share/doc/wristwise/examples/CMakeLists.txt
}

depends() {
  local name
  for name in wristwise "$(library)"; do
    field "$name" Depends | grep -E '\blibc6 \(>=.*\blibyaml-cpp' || fail "$name: libraries"
    ! field "$name" Depends | grep -E -e '-dev\b' || fail "$name depends on a -dev package"
  done
  field libwristwise-dev Depends | grep -F "$(library) (= $(version)), libeigen3-dev"
}

program() {
  rm -rf "$folder/root"
  dpkg-deb -x "$(package wristwise)" "$folder/root"
  cd "$folder/root/usr"
  bin/wristwise plan share/wristwise/problems/task_c_wrist_singularity.yaml --out "$folder/out"
  grep -q '"status": "solved"' "$folder/out/result.json"
}

lintian() {
  needs /usr/bin/lintian
  /usr/bin/lintian --allow-root --fail-on error "$folder"/*.deb
}

"$1"
