# The rows of a program and its commands, each after the command's name, as a completion for bash.
BEGIN { FS = "\t" }
{ if (!($1 in seen)) { seen[$1] = 1; command[++n] = $1 } }
$2 == "subcommand" { words[$1] = words[$1] " " $3 }
$2 == "positional" { files[$1] = 1 }
$2 == "value" { words[$1] = words[$1] " " $3 }
$2 == "option" {
  split($3, part, / /)
  gsub(/,/, " ", part[1])
  options[$1] = options[$1] " " part[1]
  names = part[1]
  gsub(/ /, "|", names)
  if (part[2] ~ /^FILE/) {
    values[$1] = values[$1] "          " names ") _epsnet_files; return ;;\n"
  } else if (part[2] ~ /\|/) {
    count = split(part[2], choice, /\|/)
    list = ""
    for (i = 1; i <= count; ++i) if (choice[i] !~ /^[A-Z][A-Z]+$/) list = list " " choice[i]
    values[$1] = values[$1] "          " names ") _epsnet_words \"" substr(list, 2) "\"; return ;;\n"
  } else if (part[2] ~ /^[A-Z]/ && part[2] != "REQUIRED" && part[2] != "Excludes:") {
    values[$1] = values[$1] "          " names ") return ;;\n"  # A number or a text.
  }
}
END {
  f = PROGRAM
  gsub(/-/, "_", f)
  print "# Completion of " PROGRAM " for bash; made from the text of its --help."
  print "_epsnet_words() { mapfile -t COMPREPLY < <(compgen -W \"$1\" -- \"$word\"); }"
  print "_epsnet_files() {"
  print "  compopt -o filenames 2>/dev/null"
  print "  mapfile -t COMPREPLY < <(compgen -f -- \"$word\")"
  print "}"
  print "_" f "() {"
  print "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} command=" PROGRAM " i"
  print "  COMPREPLY=()"
  print "  # The words before the first option name the command."
  print "  for ((i = 1; i < COMP_CWORD; ++i)); do"
  print "    case \"$command ${COMP_WORDS[i]}\" in"
  known = ""
  for (i = 2; i <= n; ++i) known = known (known == "" ? "" : "|") "\"" command[i] "\""
  if (known != "") print "      " known ") command=\"$command ${COMP_WORDS[i]}\" ;;"
  print "      *) break ;;"
  print "    esac"
  print "  done"
  print "  case $command in"
  for (i = 1; i <= n; ++i) {
    c = command[i]
    print "    \"" c "\")"
    if (values[c] != "") print "      case $before in\n" values[c] "      esac"
    if (words[c] != "") print "      [[ $word == -* ]] || { _epsnet_words \"" substr(words[c], 2) "\"; return; }"
    if (words[c] == "" && (files[c] || options[c] == "")) print "      [[ $word == -* ]] || { _epsnet_files; return; }"
    if (options[c] != "") print "      _epsnet_words \"" substr(options[c], 2) "\""
    print "      ;;"
  }
  print "  esac"
  print "}"
  print "complete -F _" f " " PROGRAM
}
