#include <bit>
#include <ostream>
#include <string>

#include "certify/base/interval.h"
#include "certify/base/text.h"
#include "netgen/distances/distances.h"

namespace epsnet {
namespace {

void append_number(std::string& bytes, double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  for (int i = 0; i < 8; ++i) bytes += static_cast<char>((bits >> (8 * i)) & 0xff);
}

}  // namespace

void write_npy(const DistanceTable& table, TableEntries entries, std::ostream& out) {
  const bool bounds = entries == TableEntries::bounds;
  std::string header = "{'descr': '<f8', 'fortran_order': False, 'shape': (" + std::to_string(table.from.size()) +
                       ", " + std::to_string(table.to.size()) + (bounds ? ", 2" : "") + "), }";
  // Magic, version and length are 10 bytes; all of it, with a line end, is a multiple of 64.
  constexpr std::size_t kBefore = 10;
  constexpr std::size_t kAlignment = 64;
  header.append((kAlignment - (kBefore + header.size() + 1) % kAlignment) % kAlignment, ' ');
  header += '\n';
  out << "\x93NUMPY" << '\x01' << '\x00' << static_cast<char>(header.size() & 0xff)
      << static_cast<char>(header.size() >> 8) << header;
  std::string row;
  for (std::size_t i = 0; i < table.from.size(); ++i) {
    row.clear();
    for (std::size_t k = 0; k < table.to.size(); ++k) {
      if (bounds) {
        append_number(row, table.enclosure(i, k).lower);
        append_number(row, table.enclosure(i, k).upper);
      } else {
        append_number(row, table.distance(i, k));
      }
    }
    out << row;
  }
}

void write_csv(const DistanceTable& table, TableEntries entries, std::ostream& out) {
  const bool bounds = entries == TableEntries::bounds;
  out << (bounds ? "from,to,lower,upper\n" : "from,to,distance\n");
  for (std::size_t i = 0; i < table.from.size(); ++i) {
    for (std::size_t k = 0; k < table.to.size(); ++k) {
      out << table.from[i] << ',' << table.to[k] << ',';
      if (bounds) {
        out << certify::decimal_below(table.enclosure(i, k).lower) << ','
            << certify::decimal_above(table.enclosure(i, k).upper);
      } else {
        out << certify::shortest(table.distance(i, k));
      }
      out << '\n';
    }
  }
}

}  // namespace epsnet
