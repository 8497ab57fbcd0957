#include "netgen/base/length.h"

#include <charconv>
#include <cmath>
#include <mpfr.h>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "netgen/base/decimal.h"

namespace epsnet {
namespace {

[[noreturn]] void reject(std::string_view text) {
  constexpr std::size_t kShown = 40;
  std::string shown(text.substr(0, kShown));
  if (text.size() > kShown) {
    shown += "...";
  }
  throw std::invalid_argument("expected a positive number such as 0.1, 1e-3 or 1/10, not \"" + shown + "\"");
}

Rational parse(const std::string& text) {
  const std::optional<Rational> value = parse_decimal(text);
  if (!value || *value <= 0) {
    reject(text);
  }
  return *value;
}

std::string shortest_decimal(double value) {
  if (!std::isfinite(value) || value <= 0) {
    reject(std::to_string(value));
  }
  char buffer[32];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr};
}

}  // namespace

bool Length::allows_pseudo_nets() const {
  const Rational twice = 2 * value_;
  // ln 2 is irrational, so enough bits tell.
  for (mpfr_prec_t bits = 128;; bits *= 2) {
    mpfr_t limit;
    mpfr_init2(limit, bits);
    mpfr_const_log2(limit, MPFR_RNDD);
    const bool below = mpfr_cmp_q(limit, twice.backend().data()) >= 0;
    mpfr_const_log2(limit, MPFR_RNDU);
    const bool above = mpfr_cmp_q(limit, twice.backend().data()) <= 0;
    mpfr_clear(limit);
    if (below != above) {
      return below;
    }
  }
}

Length::Length(std::string text) : text_(std::move(text)), value_(parse(text_)) {}

Length::Length(double value) : Length(shortest_decimal(value)) {}

}  // namespace epsnet
