#!/usr/bin/env bash
# installed_tree.sh CASE SOURCE BUILD FOLDER: a tree that `cmake --install` made, moved to FOLDER/tree.
set -euo pipefail
case=$1 source=$2 build=$3 folder=$4
tree=$folder/tree
consumer=$source/tests/consumer/consumer.cpp
problem=$tree/share/wristwise/problems/task_c_wrist_singularity.yaml
warnings=(-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror)

fail() {
  echo "$*" >&2
  exit 1
}

make() {
  rm -rf "$folder"
  cmake --install "$build" --prefix "$folder/installed"
  mv "$folder/installed" "$tree"
}

no_build_paths() {
  local found
  found=$(grep -rlF -e "$build/" -e "$source/src/" -e "$source/include/" -e "$folder/installed" \
    --exclude-dir=doc "$tree") || return 0
  fail "paths of the build in: $found"
}

# Each by itself, and nothing but Eigen and the standard library in it.
headers() {
  local header includes others
  for header in "$tree"/include/wristwise/*.hpp; do
    c++ -std=c++17 "${warnings[@]}" -fsyntax-only -x c++ -I"$tree/include" -isystem "$(eigen)" \
      -include "$header" /dev/null
  done
  includes=$(grep -rhE '^ *# *include' "$tree/include")
  others=$(grep -vE '"wristwise/[a-z_]+\.hpp"|<Eigen/[A-Za-z]+>|<[a-z_]+>' <<<"$includes") ||
    return 0
  fail "included by public headers: $others"
}

eigen() { pkg-config --cflags-only-I eigen3 | sed 's/^-I//;s/ *$//'; }

# Functions and data; templates of std and types of exceptions are everywhere.
exported_symbols() {
  local symbols others unmarked
  symbols=$(nm -DC --defined-only "$(shared_library)" | cut -d' ' -f3-)
  grep -q 'wristwise::plan(' <<<"$symbols" || fail "wristwise::plan is not exported"
  ! unmarked=$(grep -rlE '^namespace wristwise\b' "$tree/include") ||
    fail "a namespace without WRISTWISE_PUBLIC: $unmarked"
  others=$(grep -vE '\bwristwise::|\bstd::|__gnu_cxx::|^typeinfo (name )?for ' <<<"$symbols") ||
    return 0
  fail "exported besides wristwise's own: $others"
}

shared_library() { find "$tree" -name 'libwristwise.so'; }

# By somebody who may not write there: the cache of meshes is then done without.
program() {
  local run=()
  place=$(mktemp -d)
  trap 'chmod -R u+w "$place"; rm -rf "$place"' EXIT
  cp -r "$tree/bin" "$tree/share" "$place"
  mkdir -m 777 "$place/out"
  chmod -R a+rX,a-w "$place/share" "$place"
  chmod 777 "$place/out"
  [ "$(id -u)" != 0 ] || run=(setpriv --reuid=65534 --regid=65534 --clear-groups)
  "${run[@]}" "$place/bin/wristwise" plan "$place/share/wristwise/problems/task_b_mesh.yaml" \
    --out "$place/out/mesh"
  [ ! -e "$place/share/wristwise/problems/.wristwise_cache" ] || fail "it could write"
  grep -q '"status": "solved"' "$place/out/mesh/result.json"
  "${run[@]}" "$place/bin/wristwise" new "$place/out/new.yaml"
  "$place/bin/wristwise" --version | grep -x "wristwise [0-9]*\.[0-9]*\.[0-9]*"
}

# Every option of every command is in the manual page.
man_page() {
  local page option command
  page=$(gzip -dc "$tree/share/man/man1/wristwise.1.gz" | sed 's/\\-/-/g')
  for command in '' new plan smooth check compare place info; do
    # shellcheck disable=SC2086
    for option in $("$tree/bin/wristwise" $command --help | grep -oE -e '--[a-z-]+' | sort -u); do
      grep -qe "$option" <<<"$page" || fail "no $option in the manual page"
    done
    grep -qix "\.SH ${command:-name}" <<<"$page" || fail "no section $command in the manual page"
  done
}

# configure_consumer NAME [OPTION...]
configure_consumer() {
  local name=$1
  shift
  rm -rf "${folder:?}/$name"
  cmake -S "$source/tests/consumer" -B "$folder/$name" -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_PREFIX_PATH="$tree" "$@"
}

build_and_run() {
  cmake --build "$folder/$1"
  "$folder/$1/consumer" "$problem"
}

uses_shared() { readelf -d "$1" | grep 'NEEDED.*libwristwise\.so\.[0-9]*\.[0-9]*\]'; }

# It finds Eigen; every other package is hidden from it.
consumer_shared() {
  local package hidden=()
  for package in Ceres fcl urdfdom console_bridge TinyXML assimp Qhull NLopt yaml-cpp fmt Threads \
    nlohmann_json; do
    hidden+=("-DCMAKE_DISABLE_FIND_PACKAGE_$package=ON")
  done
  configure_consumer consumer_shared "${hidden[@]}"
  build_and_run consumer_shared
  uses_shared "$folder/consumer_shared/consumer"
}

consumer_static() {
  configure_consumer consumer_static -Dwristwise_SHARED_LIBS=OFF
  build_and_run consumer_static
  ! uses_shared "$folder/consumer_static/consumer" || fail "linked with the shared library"
}

# From the folder as it is installed, with its own CMake file.
examples() {
  cmake -S "$tree/share/doc/wristwise/examples" -B "$folder/examples" -DCMAKE_BUILD_TYPE=Debug \
    -DCMAKE_PREFIX_PATH="$tree"
  cmake --build "$folder/examples" --parallel 2
  local planar=$tree/share/wristwise/problems/planar_3r.yaml
  "$folder/examples/01_plan_a_seam" "$planar" "$folder/planar.csv"
  "$folder/examples/07_check_a_file" "$planar" "$folder/planar.csv" | grep -x passed
}

consumer_wider_vectors() {
  configure_consumer consumer_wider_vectors -DCMAKE_CXX_FLAGS=-march=native
  build_and_run consumer_wider_vectors
}

# found VERSION [COMPONENT...]: what a project that asks for them is given
found() {
  local version=$1 project=$folder/found_by_$case
  shift
  mkdir -p "$project"
  cat >"$project/CMakeLists.txt" <<END
cmake_minimum_required(VERSION 3.25)
project(components LANGUAGES CXX)
find_package(wristwise $version REQUIRED COMPONENTS $*)
get_target_property(chosen wristwise::wristwise ALIASED_TARGET)
message(STATUS "chosen: \${chosen}")
END
  rm -rf "$project/build"
  cmake -S "$project" -B "$project/build" -DCMAKE_PREFIX_PATH="$tree" 2>&1
}

components() {
  found 0.1 | grep -x -e '-- chosen: wristwise::shared'
  found 0.1 shared | grep -x -e '-- chosen: wristwise::shared'
  found 0.1 static shared | grep -x -e '-- chosen: wristwise::static'
  (found 0.1 dynamic || true) | grep "no component 'dynamic' here"
  ! found 0.2 || fail "0.1 was found for 0.2"
}

# Where only the archive is installed it is the one that is found.
archive_alone() {
  cp -r "$tree" "$folder/archive_alone"
  tree=$folder/archive_alone
  find "$tree" -name 'libwristwise.so*' -delete -o -name 'wristwise-shared*' -delete
  found 0.1 | grep -x -e '-- chosen: wristwise::static'
}

# pkg_config_consumer NAME [OPTION OF PKG-CONFIG...]
pkg_config_consumer() {
  local program=$folder/$1
  shift
  export PKG_CONFIG_PATH
  PKG_CONFIG_PATH=$(dirname "$(find "$tree" -name wristwise.pc)")
  # shellcheck disable=SC2046
  c++ -std=c++17 -O2 "$consumer" -o "$program" $(pkg-config --cflags --libs "$@" wristwise)
  LD_LIBRARY_PATH=$(dirname "$(shared_library)") "$program" "$problem"
}

pkg_config() {
  pkg_config_consumer pkg_config_shared
  uses_shared "$folder/pkg_config_shared"
}

pkg_config_static() {
  pkg_config_consumer pkg_config_private --static
  pkg_config_consumer pkg_config_static --static --define-variable=library=-l:libwristwise.a
  ! uses_shared "$folder/pkg_config_static" || fail "linked with the shared library"
}

"$1"
