# The rows of a command's help as its manual page. NAME: the command, as in "epsnet net"; VERSION; SEE: other pages, as in "certify, epsnet".
function escaped(s) {
  gsub(/\\/, "\\e", s)
  gsub(/-/, "\\-", s)
  if (s ~ /^[.']/) s = "\\\\&" s
  return s
}
function section(name) {
  if (current != name) print ".SH " name
  current = name
}
function page(name) { gsub(/ /, "-", name); return name }
BEGIN { FS = "\t" }
{ ++n; kind[n] = $1; head[n] = $2; text[n] = $3 }
END {
  for (i = 1; i <= n; ++i) {
    if (kind[i] == "about") about = about (about == "" ? "" : " ") text[i]
    if (kind[i] == "usage") usage = text[i]
  }
  # The first clause, or what fits a line of it, without the full stop.
  short = about
  if (match(short, /[.:;] /)) short = substr(short, 1, RSTART - 1)
  if (length(short) > 110 && match(short, /, /)) short = substr(short, 1, RSTART - 1)
  sub(/[.]$/, "", short)
  short = tolower(substr(short, 1, 1)) substr(short, 2)
  title = toupper(page(NAME))
  print ".\\\" Made from the text of " NAME " --help."
  print ".TH \"" escaped(title) "\" 1 \"\" \"epsnet " VERSION "\" \"epsnet\""
  section("NAME")
  print escaped(page(NAME)) " \\- " escaped(short)
  section("SYNOPSIS")
  rest = substr(usage, length(NAME) + 2)
  print ".B " escaped(NAME)
  print ".RI " (rest == "" ? "" : "\"" escaped(rest) "\"")
  section("DESCRIPTION")
  print escaped(about)
  title_of["positional"] = "ARGUMENTS"; title_of["option"] = "OPTIONS"; title_of["subcommand"] = "COMMANDS"
  for (i = 1; i <= n; ++i) {
    if (kind[i] == "group" && head[i] != "Subcommands") {
      section(title_of["subcommand"])
      print ".SS " escaped(head[i])
    } else if (kind[i] in title_of) {
      section(title_of[kind[i]])
      h = head[i]
      required = sub(/ REQUIRED$/, "", h)
      print ".TP"
      print ".BR \"" escaped(h) "\"" (required ? " \" (required)\"" : "")
      print escaped(text[i]) (kind[i] == "subcommand" ? " See\n.BR " escaped(page(NAME " " head[i])) " (1)." : "")
    }
  }
  for (i = 1; i <= n; ++i) {
    if (kind[i] != "note") continue
    if (text[i] ~ /^Exit codes?[: ]/) {
      section("EXIT STATUS")
      status = text[i]
      sub(/^Exit codes: /, "", status)
      print escaped(status)
    } else if (text[i] == "") {
      if (current == "NOTES") print ".PP"
    } else {
      if (current != "EXIT STATUS") section("NOTES")
      print escaped(text[i])
    }
  }
  for (i = 1; i <= n; ++i) {
    if (kind[i] != "example") continue
    if (current != "EXAMPLES") { section("EXAMPLES"); print ".nf" }
    print escaped(text[i])
  }
  if (current == "EXAMPLES") print ".fi"
  section("SEE ALSO")
  count = split(SEE, see, / /)
  for (i = 1; i <= count; ++i) print ".BR " escaped(see[i]) " (1)" (i < count ? "," : "")
}
