# The rows of a program and its commands, each after the command's name, as a completion for zsh.
function quoted(s) { gsub(/'/, "'\\''", s); return s }
function described(s) { gsub(/[\[\]\\:]/, "\\\\&", s); return quoted(s) }
function action(value,   count, choice, i, list) {
  if (value ~ /^FILE/) return ":file:_files"
  if (value ~ /\|/) {
    count = split(value, choice, /\|/)
    for (i = 1; i <= count; ++i) if (choice[i] !~ /^[A-Z][A-Z]+$/) list = list " " choice[i]
    return ":value:(" substr(list, 2) ")"
  }
  if (value ~ /^[A-Z]/ && value != "REQUIRED" && value != "Excludes:") return ":" described(value) ": "
  return ""
}
BEGIN { FS = "\t" }
{ if (!($1 in seen)) { seen[$1] = 1; command[++n] = $1 } }
$2 == "subcommand" { words[$1] = words[$1] " '" $3 ":" described($4) "'" }
$2 == "positional" { files[$1] = 1 }
$2 == "value" { values[$1] = values[$1] " " $3 }
$2 == "option" {
  split($3, part, / /)
  count = split(part[1], name, /,/)
  excluded = ""
  for (i = 1; i <= count; ++i) excluded = excluded " " name[i]
  for (i = 1; i <= count; ++i)
    specs[$1] = specs[$1] " \\\n        '" (count > 1 ? "(" substr(excluded, 2) ")" : "") name[i] "[" described($4) "]" action(part[2]) "'"
}
END {
  f = PROGRAM
  gsub(/-/, "_", f)
  print "#compdef " PROGRAM
  print "# Completion of " PROGRAM " for zsh; made from the text of its --help."
  print "local command=" PROGRAM
  print "local -i i=2"
  print "# The words before the first option name the command."
  print "while (( i < CURRENT )); do"
  print "  case \"$command $words[i]\" in"
  known = ""
  for (i = 2; i <= n; ++i) known = known (known == "" ? "" : "|") "\"" command[i] "\""
  if (known != "") print "    " known ") command=\"$command $words[i]\" ;;"
  print "    *) break ;;"
  print "  esac"
  print "  (( ++i ))"
  print "done"
  print "# What is left is completed as a command of its own."
  print "shift $(( i - 2 )) words"
  print "(( CURRENT -= i - 2 ))"
  print "case $command in"
  for (i = 1; i <= n; ++i) {
    c = command[i]
    print "  \"" c "\")"
    if (words[c] != "") {
      print "    if (( CURRENT == 2 )) && [[ $words[2] != -* ]]; then"
      print "      local -a commands=(" substr(words[c], 2) ")"
      print "      _describe command commands"
      print "      return"
      print "    fi"
    }
    if (values[c] != "") specs[c] = specs[c] " \\\n        '*:value:(" substr(values[c], 2) ")'"
    print "    _arguments" specs[c] (values[c] == "" && files[c] || specs[c] == "" ? " \\\n        '*:file:_files'" : "")
    print "    ;;"
  }
  print "esac"
}
