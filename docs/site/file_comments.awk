# A comment before the line that opens a namespace is about the header. The empty line before it says so to Doxygen; lines keep their numbers.
{ line[NR] = $0 }
END {
  for (i = NR; i > 0; --i) {
    if (line[i] ~ /^namespace /) {
      for (j = i - 1; line[j] ~ /^\/\/\//; --j);
      if (j < i - 1 && line[j] == "") line[j] = "/// \\file"
    }
  }
  for (i = 1; i <= NR; ++i) print line[i]
}
