# The text of --help as rows KIND<tab>HEAD<tab>TEXT. Kinds: about, usage, positional, option, subcommand (a head and its text); group (the name of the
# subcommands that follow); example (a line, its
# spaces kept); note (a line; empty between paragraphs).
function trim(s) { sub(/^ +/, "", s); sub(/ +$/, "", s); return s }
function row(kind, head, text) { printf "%s\t%s\t%s\n", kind, head, text }
{ gsub(/\t/, " "); line[NR] = $0 }
END {
  section = "about"
  for (i = 1; i <= NR; ++i) {
    l = line[i]
    while (l ~ /^  -.*\|$/) {  # A head with many choices goes on.
      more = line[++i]
      l = l trim(more)
    }
    if (l ~ /^Usage: /) {
      row("usage", "", substr(l, 8))
    } else if (l ~ /^(Positionals|Options):$/) {
      section = tolower(substr(l, 1, length(l) - 2))
    } else if (l ~ /^Examples?:$/) {
      section = "example"
    } else if (l ~ /^[A-Z][a-z ]*:$/ && line[i + 1] ~ /^  [a-z]/) {
      # A group of commands, under a name of its own.
      section = "subcommand"
      row("group", substr(l, 1, length(l) - 1), "")
    } else if (section == "about") {
      if (l != "") { row("about", "", l); about = 1 } else if (about) section = "note"
    } else if (section == "example") {
      if (l == "") section = "note"; else row("example", "", substr(l, 3))
    } else if (section == "note") {
      row("note", "", l)
    } else if (l == "") {
      section = "note"
    } else if (l ~ /^ ? ?[^ ]/) {
      # The head ends at two spaces or, where it is long, at column 30 or at the end of the line.
      head = substr(l, 3)
      text = ""
      if (match(head, /  +/) && RSTART < 30) {
        text = substr(head, RSTART + RLENGTH)
        head = substr(head, 1, RSTART - 1)
      } else if (substr(l, 30, 1) == " " || line[i + 1] !~ /^          /) {
        text = substr(l, 31)
        head = trim(substr(l, 3, 28))
      }
      while (line[i + 1] ~ /^          /) text = text (text == "" ? "" : " ") trim(line[++i])
      row(section, head, text)
    }
  }
}
