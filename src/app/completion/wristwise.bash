# Tab completion for wristwise, in bash.
# Installed to share/bash-completion/completions/wristwise, where bash-completion finds it; else:
#   source wristwise.bash

_wristwise_commands="new plan smooth check compare place info help"
_wristwise_options="--help --version --quiet --threads --no-cache --color"

_wristwise_without_value="-h --help --version --quiet --no-cache --force --no-self-collision --no-report --plot --json"

# Options of a command beside those of every command.
_wristwise_options_of() {
  case $1 in
    new) echo "--force --robot --base --part --tip --limits --seam" ;;
    plan) echo "--mode --out --export --no-report --plot" ;;
    smooth) echo "--joints --smoothing-time --urdf --base --part --tip --limits --keep \
      --no-self-collision --out --export --no-report --plot" ;;
    check) echo "--json" ;;
    compare) echo "--out --no-report --plot" ;;
    place) echo "--out" ;;
    info) echo "--base --part --tip --limits --srdf --group --package --collision-from" ;;
  esac
}

# Files with one of the extensions, and folders: _wristwise_files WORD EXTENSION...
_wristwise_files() {
  local word=$1 path extension slash=/
  shift
  compopt -o filenames 2>/dev/null && slash=  # readline adds it, and quotes
  while IFS= read -r path; do
    if [[ -d $path ]]; then
      COMPREPLY+=("$path$slash")
      continue
    fi
    for extension in "$@"; do
      [[ $path == *."$extension" ]] && COMPREPLY+=("$path")
    done
  done < <(compgen -f -- "$word")
}

_wristwise_words() {
  local word=$1
  shift
  while IFS= read -r path; do COMPREPLY+=("$path"); done < <(compgen -W "$*" -- "$word")
}

# A list with commas: what is there already stays, and is not offered again.
_wristwise_list() {
  local word=$1 before= name
  shift
  [[ $word == *,* ]] && before=${word%,*},
  for name in "$@"; do
    [[ ,$before == *,$name,* || $before$name != "$word"* ]] || COMPREPLY+=("$before$name")
  done
  compopt -o nospace 2>/dev/null
}

_wristwise_takes_value() {
  [[ $1 == -* && " $_wristwise_without_value " != *" $1 "* ]]
}

# The value of an option: _wristwise_value OPTION WORD
_wristwise_value() {
  local word=$2
  case $1 in
    --mode) _wristwise_words "$word" two-stage graph-only ;;
    --export) _wristwise_list "$word" krl rapid ls trajectory_msgs moveit ;;
    --color) _wristwise_words "$word" auto always never ;;
    --collision-from) _wristwise_words "$word" collision visual ;;
    --seam) _wristwise_words "$word" line arc csv ;;
    --joints) _wristwise_files "$word" csv yaml src mod ls ;;
    --urdf | --robot) _wristwise_files "$word" urdf ;;
    --limits) _wristwise_files "$word" yaml ;;
    --srdf) _wristwise_files "$word" srdf ;;
    --out | --package) _wristwise_files "$word" ;;
  esac
}

# The argument of a command: _wristwise_argument COMMAND WORD ARGUMENTS-BEFORE
_wristwise_argument() {
  case $1 in
    info) _wristwise_files "$2" urdf ;;
    check) if (($3 > 0)); then _wristwise_files "$2" csv; else _wristwise_files "$2" yaml yml; fi ;;
    help) _wristwise_words "$2" ${_wristwise_commands% help} ;;
    *) _wristwise_files "$2" yaml yml ;;
  esac
}

_wristwise() {
  local word=${COMP_WORDS[COMP_CWORD]} command= i arguments=0 path
  COMPREPLY=()
  for ((i = 1; i < COMP_CWORD; i++)); do
    if _wristwise_takes_value "${COMP_WORDS[i]}"; then
      [[ ${COMP_WORDS[i + 1]} == = ]] && ((i++))
      ((i++))
    elif [[ ${COMP_WORDS[i]} == -* ]]; then
      continue
    elif [[ -z $command ]]; then
      command=${COMP_WORDS[i]}
    else
      ((arguments++))
    fi
  done
  local before=${COMP_WORDS[COMP_CWORD - 1]}
  if [[ $word == = ]]; then  # bash cuts --option=value in three
    word=
  elif [[ $before == = ]]; then
    before=${COMP_WORDS[COMP_CWORD - 2]}
  fi
  if _wristwise_takes_value "$before"; then
    _wristwise_value "$before" "$word"
  elif [[ $word == -* ]]; then
    _wristwise_words "$word" $_wristwise_options $(_wristwise_options_of "$command")
  elif [[ -z $command ]]; then
    _wristwise_words "$word" $_wristwise_commands
  else
    _wristwise_argument "$command" "$word" "$arguments"
  fi
}

complete -F _wristwise wristwise
