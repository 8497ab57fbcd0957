#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

/// Numbers of binary64 side by side, for compilers that have vectors (g++, clang), whatever their library has.
namespace epsnet::certify::filter {

/// The answers to a question about each of the lanes.
class Mask {
 public:
  using Vector [[gnu::vector_size(16)]] = std::int64_t;  // 0 or −1.

  explicit Mask(Vector answers) : answers_(answers) {}
  [[nodiscard]] bool operator[](std::size_t lane) const { return answers_[lane] != 0; }
  [[nodiscard]] Vector vector() const { return answers_; }

  friend Mask operator&&(const Mask& a, const Mask& b) { return Mask(a.answers_ & b.answers_); }

 private:
  Vector answers_;
};

/// One number in each lane. Operations are those of binary64, lane by lane.
class Lanes {
 public:
  using Vector [[gnu::vector_size(16)]] = double;

  Lanes() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): a number among lanes is the same in all of them.
  Lanes(double number) : numbers_{number, number} {}
  /// The numbers from this one on.
  explicit Lanes(const double* first) { std::memcpy(&numbers_, first, sizeof numbers_); }

  [[nodiscard]] static constexpr std::size_t size() { return sizeof(Vector) / sizeof(double); }
  [[nodiscard]] double operator[](std::size_t lane) const { return numbers_[lane]; }

  friend Lanes operator+(const Lanes& a, const Lanes& b) { return Lanes(a.numbers_ + b.numbers_); }
  friend Lanes operator-(const Lanes& a, const Lanes& b) { return Lanes(a.numbers_ - b.numbers_); }
  friend Lanes operator*(const Lanes& a, const Lanes& b) { return Lanes(a.numbers_ * b.numbers_); }
  friend Lanes operator/(const Lanes& a, const Lanes& b) { return Lanes(a.numbers_ / b.numbers_); }
  friend Mask operator<(const Lanes& a, const Lanes& b) { return Mask(Mask::Vector(a.numbers_ < b.numbers_)); }
  friend Mask operator>(const Lanes& a, const Lanes& b) { return b < a; }

  /// `yes` in the lanes where the mask is true, `no` in the others.
  friend Lanes select(const Mask& mask, const Lanes& yes, const Lanes& no) {
    return Lanes(Vector((mask.vector() & Mask::Vector(yes.numbers_)) | (~mask.vector() & Mask::Vector(no.numbers_))));
  }
  friend Lanes max(const Lanes& a, const Lanes& b) { return select(a > b, a, b); }
  friend Lanes abs(const Lanes& a) { return max(a, Lanes(-a.numbers_)); }

 private:
  explicit Lanes(Vector numbers) : numbers_(numbers) {}

  Vector numbers_;
};

}  // namespace epsnet::certify::filter
