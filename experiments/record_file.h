#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// The file of a surface in a sweep. It has a line of parameters, the names of the columns, a record for each net
/// (netgen/nets/net_record.h) or one for its systole, and a last line with the number of records and the CRC-32 of all
/// lines before it. A file that is incomplete, or was made with other parameters, is not finished.
namespace epsnet::experiments {

/// Returns "# epsnet 0.1.0, sweep 1, TEXT": the versions of the program and of the format, then the parameters on which
/// the results depend.
[[nodiscard]] std::string parameter_line(const std::string& text);

/// Returns the whole file. `head` is the line of parameters and that of the columns, without the last line end.
[[nodiscard]] std::string record_file(const std::string& head, const std::vector<std::string>& records);

/// Whether there is a complete file with this head and this number of records.
[[nodiscard]] bool is_finished(const std::filesystem::path& path, const std::string& head, std::size_t records);

/// Returns the CRC-32 (ISO 3309, as in zlib) in eight hexadecimal digits.
[[nodiscard]] std::string checksum(const std::string& bytes);

/// Returns the contents of a file. Throws std::runtime_error with the path and the reason.
[[nodiscard]] std::string read_file(const std::filesystem::path& path);

}  // namespace epsnet::experiments
