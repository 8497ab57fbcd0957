#include "experiments/record_file.h"

#include <algorithm>
#include <boost/crc.hpp>
#include <cerrno>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>

namespace epsnet::experiments {

std::string parameter_line(const std::string& text) { return "# epsnet " EPSNET_VERSION ", sweep 1, " + text; }

std::string record_file(const std::string& head, const std::vector<std::string>& records) {
  std::string result = head + '\n';
  for (const std::string& record : records) result += record + '\n';
  return result + "# complete: " + std::to_string(records.size()) + " records, CRC-32 " + checksum(result) + '\n';
}

bool is_finished(const std::filesystem::path& path, const std::string& head, std::size_t records) {
  if (!std::filesystem::exists(path)) return false;
  const std::string file = read_file(path);
  const std::size_t last = file.rfind("# complete: ");
  if (last == std::string::npos) return false;
  const std::string before = file.substr(0, last);
  return file.starts_with(head + '\n') &&
         file.substr(last) ==
             "# complete: " + std::to_string(records) + " records, CRC-32 " + checksum(before) + '\n' &&
         std::count(before.begin(), before.end(), '\n') == static_cast<std::ptrdiff_t>(records + 2);
}

std::string checksum(const std::string& bytes) {
  boost::crc_32_type crc;
  crc.process_bytes(bytes.data(), bytes.size());
  char text[9];
  std::snprintf(text, sizeof text, "%08x", crc.checksum());
  return text;
}

std::string read_file(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in.is_open() || std::filesystem::is_directory(path))
    throw std::runtime_error(
        path.string() + ": cannot be read: " + (in.is_open() ? "a directory" : std::system_category().message(errno)));
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace epsnet::experiments
