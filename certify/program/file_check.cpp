#include <array>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <deque>
#include <exception>
#include <iostream>
#include <mutex>
#include <nettle/sha2.h>
#include <optional>
#include <sstream>
#include <string_view>
#include <thread>
#include <unistd.h>
#include <utility>

#include "certify/base/error.h"
#include "certify/check.h"
#include "certify/file/compact.h"
#include "certify/file/document_reader.h"
#include "certify/file/file.h"
#include "certify/program/output.h"

namespace epsnet::certify::program {
namespace {

/// Shows how far we are on a terminal, after the first second; wipes its line at the end.
class Progress {
 public:
  void show(std::string_view rule, double share) {
    const auto now = std::chrono::steady_clock::now();
    if (!terminal_ || now - shown_ < std::chrono::milliseconds(shown_once_ ? 200 : 1000)) return;
    shown_ = now;
    shown_once_ = true;
    std::fprintf(stderr, "\r%-14.*s %3.0f %%", static_cast<int>(rule.size()), rule.data(), 100 * share);
  }
  ~Progress() {
    if (shown_once_) std::fputs("\r                      \r", stderr);
  }

 private:
  bool terminal_ = isatty(STDERR_FILENO) != 0;
  bool shown_once_ = false;
  std::chrono::steady_clock::time_point shown_ = std::chrono::steady_clock::now();
};

class Sha256 {
 public:
  Sha256() { sha256_init(&context_); }
  void add(std::string_view bytes) {
    sha256_update(&context_, bytes.size(), reinterpret_cast<const std::uint8_t*>(bytes.data()));
  }
  /// Of what was added. At the end.
  [[nodiscard]] std::string text() {
    std::array<std::uint8_t, SHA256_DIGEST_SIZE> digest{};
    sha256_digest(&context_, digest.size(), digest.data());
    std::string text;
    for (const std::uint8_t byte : digest) {
      constexpr std::string_view kDigits = "0123456789abcdef";
      text += {kDigits[byte / 16U], kDigits[byte % 16U]};
    }
    return text;
  }

 private:
  sha256_ctx context_{};
};

/// The checksum of a file that is read in pieces, made in a thread of its own from the second piece on.
class Sha256InBackground {
 public:
  explicit Sha256InBackground(bool alone) : alone_(alone) {}
  ~Sha256InBackground() { finish(); }
  Sha256InBackground(const Sha256InBackground&) = delete;
  Sha256InBackground& operator=(const Sha256InBackground&) = delete;

  void add(std::string_view piece) {
    if (alone_ || !std::exchange(begun_, true)) return sum_.add(piece);
    if (!thread_.joinable()) thread_ = std::thread([this] { work(); });
    constexpr std::size_t kMostPieces = 8;
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return pieces_.size() < kMostPieces; });
    pieces_.emplace_back(piece);
    changed_.notify_all();
  }
  /// Of what was added. At the end.
  [[nodiscard]] std::string text() {
    finish();
    return sum_.text();
  }

 private:
  void finish() {
    if (!thread_.joinable()) return;
    {
      const std::lock_guard lock(mutex_);
      finished_ = true;
    }
    changed_.notify_all();
    thread_.join();
  }

  void work() {
    std::unique_lock lock(mutex_);
    for (;;) {
      changed_.wait(lock, [&] { return finished_ || !pieces_.empty(); });
      if (pieces_.empty()) return;
      const std::string piece = std::move(pieces_.front());
      pieces_.pop_front();
      lock.unlock();
      changed_.notify_all();
      sum_.add(piece);
      lock.lock();
    }
  }

  bool alone_;
  bool begun_ = false;
  Sha256 sum_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::string> pieces_;
  bool finished_ = false;
  std::thread thread_;
};

/// What the second checker says of the bytes, and what follows from it.
void add_second_opinion(FileReport& report, std::string_view bytes, bool exact) {
  const SecondOpinion opinion = ask_second_checker(bytes, exact);
  if (opinion.rule == exact::kLeftOut) {
    report.not_asked = opinion.message;
    return;
  }
  report.second = opinion;
  report.certificate = agreed(std::move(report.certificate), opinion);
}

std::string without_name(const std::exception& error, const FileReport& report) {
  const std::string_view text = error.what();
  const std::string prefix = report.name + ": ";
  return std::string(text.starts_with(prefix) ? text.substr(prefix.size()) : text);
}

constexpr std::string_view kSurface = "a surface file";

/// What a file is that epsnet writes and that claims nothing, by its beginning; empty for all others.
std::string_view kind_without_claim(std::string_view beginning) {
  using Kinds = std::pair<std::string_view, std::string_view>;
  static constexpr Kinds kFormats[] = {{"epsnet-surface", kSurface},
                                       {"epsnet-dirichlet", "a Dirichlet domain"},
                                       {"epsnet-matrices", "a file of matrices"},
                                       {"epsnet-mesh", "a mesh"}};
  static constexpr Kinds kBeginnings[] = {{"<svg", "an SVG picture"},
                                          {"\x89PNG", "a PNG picture"},
                                          {"<!DOCTYPE html", "an HTML page"},
                                          {"OFF\n", "a mesh"},
                                          {"<?xml", "a file of XML, such as VTU"},
                                          {"$MeshFormat", "a mesh"},
                                          {"MeshVersionFormatted", "a mesh"},
                                          {"MFEM mesh", "a mesh"},
                                          {"%%MatrixMarket", "a MatrixMarket matrix"},
                                          {"\x93NUMPY", "a NumPy array"},
                                          {"u\tv\t", "a table"},
                                          {"from,to,", "a table"},
                                          {"step,", "a table"}};
  ByteStream stream(beginning);
  const std::optional<std::string> format = format_of(stream);
  for (const auto& [name, kind] : kFormats) {
    if (format == name) return kind;
  }
  for (const auto& [bytes, kind] : kBeginnings) {
    if (beginning.starts_with(bytes)) return kind;
  }
  const std::size_t digits = std::min(beginning.find_first_not_of("0123456789"), beginning.size());
  const bool is_number = digits > 0 && digits < beginning.size() &&
                         std::string_view(" \t\n\r").find(beginning[digits]) != std::string_view::npos;
  return is_number ? "a text of numbers, as of CGAL" : "";
}

/// What is said of a file of such a kind. A surface file is read as what it is: it may be malformed.
FileReport report_without_claim(FileReport report, std::string_view kind, std::string_view bytes) {
  if (kind != kSurface) {
    report.no_claim = "this begins as " + std::string(kind) + ", which claims nothing; files of nets and of answers do";
    return report;
  }
  try {
    (void)parse_file<SurfaceDocument>(bytes, report.name);
    report.no_claim =
        "this is a surface file, which claims nothing; epsnet net FILE --epsilon 0.1 -o net.json makes a net of it";
  } catch (const MalformedError& error) {
    report.certificate = malformed(without_name(error, report));
  }
  return report;
}

FileReport check_bytes(const Request& request, const std::string& path) {
  FileReport report{.name = display_name(path), .path = path};
  Sha256InBackground sum(request.options.threads == 1);
  std::string bytes;  // Kept for the second checker, if it may be asked about them, and those of a surface file.
  bool seen = false;
  bool kept = true;
  std::string_view kind;  // Of files that claim nothing; those of surfaces are read again.
  const auto witness = [&](std::string_view piece) {
    if (!std::exchange(seen, true)) kind = kind_without_claim(piece);
    sum.add(piece);
    kept = kept && (request.exact || kind == kSurface || bytes.size() + piece.size() <= kBytesCheckedTwice);
    if (kept) {
      bytes += piece;
    } else {
      std::string().swap(bytes);
    }
  };
  // Of compact files the second checker knows only what a reader made of them.
  const auto ask_about_malformed = [&] {
    if (seen && kept && !is_compact(bytes)) add_second_opinion(report, bytes, request.exact);
  };
  ClaimDocument document;
  try {
    document = read_file<ClaimDocument>(path, witness, Structure::unchecked);
    report.sha256 = sum.text();
  } catch (const FileError& error) {
    report.error = without_name(error, report);
    return report;
  } catch (const MalformedError& error) {
    if (seen) report.sha256 = sum.text();
    if (!kind.empty()) return report_without_claim(std::move(report), kind, bytes);
    report.certificate = malformed(without_name(error, report));
    ask_about_malformed();
    return report;
  }
  Progress progress;
  CheckOptions options = request.options;
  if (!options.progress) options.progress = [&](std::string_view rule, double share) { progress.show(rule, share); };
  report.certificate = check(document, options);
  report.is_claim = report.certificate.verdict != Verdict::malformed;
  if (!report.is_claim) {
    ask_about_malformed();
    return report;
  }
  if (request.print_parsed) write_file(document, std::cout);
  const AnyClaim claim(document);
  const NetDocument& net = claim.net();
  if (kept && (request.exact || net.triangles.size() <= kTrianglesCheckedTwice)) {
    options.progress("second checker", 0);
    if (is_compact(bytes)) {
      std::ostringstream text;
      write_file(net, text);
      bytes = std::move(text).str();
    }
    add_second_opinion(report, bytes, request.exact);
  } else {
    report.not_asked = "more than " + std::to_string(kTrianglesCheckedTwice) + " triangles or 4 MB; --exact asks it";
  }
  return report;
}

}  // namespace

FileReport check_file(const Request& request, const std::string& path) {
  try {
    return check_bytes(request, path);
  } catch (const Fault& fault) {
    return {.name = display_name(path),
            .path = path,
            .error = fault.what() + std::string("; please report this, with the file, to the authors of epsnet"),
            .fault = true};
  }
}

}  // namespace epsnet::certify::program
