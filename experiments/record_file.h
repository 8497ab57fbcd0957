#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// The file of a surface in a sweep: a line of parameters, the names of the columns, a record for each net
/// (netgen/nets/net_record.h) or the one of its systole, and a last line that says how many they are and the CRC-32 of
/// all before it. A file that an interruption cut short, or that was made with other parameters, is no result.
namespace epsnet::experiments {

/// "# epsnet 0.1.0, sweep 1, TEXT": the version of the program and of the format, then what the results depend on.
[[nodiscard]] std::string parameter_line(const std::string& text);

/// The whole file. `head`: the line of parameters and that of the columns, without the last line end.
[[nodiscard]] std::string record_file(const std::string& head, const std::vector<std::string>& records);

/// Is there a complete file with this head and so many records?
[[nodiscard]] bool is_finished(const std::filesystem::path& path, const std::string& head, std::size_t records);

/// CRC-32 (ISO 3309, as in zlib), eight hexadecimal digits.
[[nodiscard]] std::string checksum(const std::string& bytes);

/// Throws std::runtime_error: the path and the reason.
[[nodiscard]] std::string read_file(const std::filesystem::path& path);

}  // namespace epsnet::experiments
