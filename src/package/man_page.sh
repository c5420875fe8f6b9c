#!/bin/sh
# man_page.sh PROGRAM VERSION: its manual page, of what it says of itself, on stdout.
set -eu
program=$1

# Text as it is.
verbatim() {
  echo .nf
  sed -e 's/\\/\\e/g' -e 's/-/\\-/g' -e "s/^\([.']\)/\\\\\&\1/"
  echo .fi
}

cat <<END
.TH WRISTWISE 1 "" "wristwise $2" "User Commands"
.SH NAME
wristwise \- planner for arc\-welding robots
.SH DESCRIPTION
END
NO_COLOR=1 "$program" --help | verbatim
commands=$("$program" --help | sed -n '/^\(Sub\)\{0,1\}[Cc]ommands/,/^$/s/^  \([a-z]*\) .*/\1/p')
for command in $commands; do
  echo ".SH $command" | tr '[:lower:]' '[:upper:]'
  NO_COLOR=1 "$program" "$command" --help | verbatim
done
