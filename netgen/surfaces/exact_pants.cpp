#include "netgen/surfaces/exact_pants.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "netgen/base/gmp.h"
#include "netgen/surfaces/exact_isometries.h"
#include "netgen/surfaces/number_field.h"
#include "triangulation/surface/exact_polygons.h"

namespace epsnet {

Rational simplest_between(Rational low, Rational high) {
  // Follows the continued fractions of both ends as long as they agree; these are the last two convergents.
  std::array<Rational, 2> above{1, 0};
  std::array<Rational, 2> below{0, 1};
  for (;;) {
    const Integer whole = numerator(low) / denominator(low);
    const bool ends = Rational(whole) == low || Rational(whole + 1) <= high;
    const Rational digit = Rational(whole) == low ? Rational(whole) : ends ? Rational(whole + 1) : Rational(whole);
    above = {above[0] * digit + above[1], above[0]};
    below = {below[0] * digit + below[1], below[0]};
    if (ends) return above[0] / below[0];
    const Rational new_low = 1 / (high - digit);
    high = 1 / (low - digit);
    low = new_low;
  }
}

Rational simplest_near(const Mp1024& x, int bits) {
  const Mp1024 margin = boost::multiprecision::ldexp(x, -bits);
  return simplest_between(Rational(Mp1024(x - margin)), Rational(Mp1024(x + margin)));
}

std::optional<Rational> rational_root(const Rational& x) {
  const Integer above = sqrt(numerator(x));
  const Integer below = sqrt(denominator(x));
  if (above * above != numerator(x) || below * below != denominator(x)) return std::nullopt;
  return Rational(above, below);
}

namespace {

using std::size_t;

// ---- Lengths nearby with rational √Δ ----

std::string text_of(const Rational& x) { return "(" + x.str() + ")"; }

/// A positive integer times which a number is an algebraic integer.
Integer denominator_of_number(const std::string& text) {
  NumberFieldReader reader;
  reader.add(text);
  return Integer(denominator_of(reader.numbers().back()).get_mpz_t());
}

/// Edges of one length.
struct LengthClass {
  std::optional<Mp1024> wanted;   ///< Of a decimal length: cosh(length/2) − 1.
  std::optional<Rational> value;  ///< cosh(length/2), if it is rational, as soon as it is known.
  std::string text;               ///< cosh(length/2).
  Integer denominator = 1;        ///< Times this it is an algebraic integer.
};

/// The classes of the cuffs of a pair of pants, in order.
using PantsType = std::array<size_t, 3>;

Rational discriminant(const Rational& a, const Rational& b, const Rational& c) {
  return a * a + b * b + c * c + 2 * a * b * c - 1;
}

/// Chooses cosh(length/2) of decimal lengths.
class LengthChooser {
 public:
  /// Stops, without numbers, as soon as it is known that more than most_roots are irrational.
  LengthChooser(const FenchelNielsen& coordinates, size_t most_roots, PantsNumbers& numbers) {
    read_classes(coordinates);
    order_types();
    if (!choose(most_roots)) return;
    is_chosen_ = true;
    for (const size_t k : class_of_edge_) numbers.cosh.push_back(classes_[k].text);
    std::map<PantsType, std::string> roots;
    for (const PantsType& type : types_) roots[type] = root_of(type);
    for (const PantsType& type : type_of_pants_) numbers.root.push_back(roots[type]);
  }

  [[nodiscard]] bool is_chosen() const { return is_chosen_; }
  /// The number of different √Δ that are not known to be rational.
  [[nodiscard]] size_t irrational() const { return irrational_; }
  /// The bits of the largest integer of which there is a root.
  [[nodiscard]] size_t bits_of_roots() const { return bits_of_roots_; }

 private:
  void read_classes(const FenchelNielsen& coordinates) {
    std::map<Rational, size_t> decimals;
    std::map<std::string, size_t> exact;
    for (size_t e = 0; e < coordinates.lengths.size(); ++e) {
      const bool is_exact = !coordinates.exact_lengths.empty() && coordinates.exact_lengths[e];
      const std::string text = is_exact ? cosh_text(*coordinates.exact_lengths[e], Rational(1, 2)) : "";
      const auto [place, is_new] =
          is_exact ? exact_place(exact, text) : decimal_place(decimals, coordinates.lengths[e]);
      class_of_edge_.push_back(place);
      if (!is_new) continue;
      LengthClass& made = classes_.emplace_back();
      if (is_exact) {
        made.value = rational_value(text);
        made.text = made.value ? text_of(*made.value) : text;
        made.denominator = denominator_of_number(text);
      } else {
        const Mp1024 sinh_of_quarter = sinh(Mp1024(Rational(coordinates.lengths[e] / 4)));
        made.wanted = 2 * sinh_of_quarter * sinh_of_quarter;
      }
    }
    for (std::uint32_t p = 0; p < coordinates.graph.pants_count(); ++p) {
      PantsType type;
      for (std::uint32_t k = 0; k < 3; ++k) type[k] = class_of_edge_[coordinates.graph.edge_at(p, k)];
      std::sort(type.begin(), type.end());
      type_of_pants_.push_back(type);
      types_.insert(type);
    }
  }

  [[nodiscard]] std::pair<size_t, bool> exact_place(std::map<std::string, size_t>& known,
                                                    const std::string& text) const {
    const auto [place, is_new] = known.emplace(text, classes_.size());
    return {place->second, is_new};
  }
  [[nodiscard]] std::pair<size_t, bool> decimal_place(std::map<Rational, size_t>& known, const Rational& length) const {
    const auto [place, is_new] = known.emplace(length, classes_.size());
    return {place->second, is_new};
  }

  /// Of a type one class that no other type has makes √Δ rational. What is left without it may have one then.
  void order_types() {
    std::vector<size_t> uses(classes_.size());
    std::vector<PantsType> left;
    const auto each_class = [](const PantsType& type, const auto& use) {
      for (size_t k = 0; k < 3; ++k) {
        if (k == 0 || type[k] != type[k - 1]) use(type[k]);
      }
    };
    const auto is_rational = [&](size_t k) { return classes_[k].wanted || classes_[k].value; };
    for (const PantsType& type : types_) {
      if (!std::all_of(type.begin(), type.end(), is_rational)) continue;
      left.push_back(type);
      each_class(type, [&](size_t k) { ++uses[k]; });
    }
    while (!left.empty()) {
      std::vector<PantsType> kept;
      std::vector<PantsType> gone;
      for (const PantsType& type : left) {
        std::optional<size_t> own;
        each_class(type, [&](size_t k) {
          if (classes_[k].wanted && uses[k] == 1) own = k;
        });
        if (own) solved_.emplace_back(type, *own);
        (own ? gone : kept).push_back(type);
      }
      // None: one √Δ stays as it is.
      if (gone.empty()) {
        gone.push_back(kept.back());
        kept.pop_back();
      }
      for (const PantsType& type : gone) each_class(type, [&](size_t k) { --uses[k]; });
      left = std::move(kept);
    }
    std::reverse(solved_.begin(), solved_.end());
  }

  /// Whether at most so many roots are known to be irrational.
  bool choose(size_t most_roots) {
    std::vector<bool> is_solved(classes_.size());
    for (const auto& [type, k] : solved_) is_solved[k] = true;
    for (size_t k = 0; k < classes_.size(); ++k) {
      if (classes_[k].wanted && !is_solved[k]) set(k, simplest(k));
    }
    size_t failures = 0;
    for (const auto& [type, k] : solved_) {
      const std::optional<Rational> found = with_rational_root(type, k);
      if (!found && ++failures > most_roots) return false;
      set(k, found.value_or(simplest(k)));
    }
    return true;
  }

  void set(size_t k, const Rational& value) {
    classes_[k].value = value;
    classes_[k].text = text_of(value);
    classes_[k].denominator = denominator(value);
  }

  /// d ln(length) is at most the relative error of c − 1.
  static constexpr int kBits = 52;

  [[nodiscard]] Rational simplest(size_t k) const { return 1 + simplest_near(*classes_[k].wanted, kBits); }

  /// A value of class k, which is the only one of the type that is not known, for which √Δ is rational; nullopt, if all
  /// that are near have too many digits.
  [[nodiscard]] std::optional<Rational> with_rational_root(const PantsType& type, size_t k) const {
    std::vector<Rational> known;
    for (const size_t other : type) {
      if (other != k) known.push_back(*classes_[other].value);
    }
    const Mp1024 c = 1 + *classes_[k].wanted;
    const auto root = [](const Mp1024& x) { return Mp1024(sqrt(x)); };
    if (known.size() == 2) {
      // (c + ab)² − Δ = (a² − 1)(b² − 1): for any w = c + ab + √Δ.
      const Rational& a = known[0];
      const Rational& b = known[1];
      const Rational product = (a * a - 1) * (b * b - 1);
      const Mp1024 middle = c + Mp1024(Rational(a * b));
      return nearest(k, Mp1024(middle + root(Mp1024(middle * middle - Mp1024(product)))),
                     [&](const Rational& w) { return Rational((w + product / w) / 2 - a * b); });
    }
    if (known.size() == 1) {
      // Δ = 2(b + 1)c² + b² − 1 is (b + 1)² for c = 1: m is the slope of a line through this point of the conic.
      const Rational b = known[0] + 1;
      const Mp1024 real = Mp1024(b);
      const Mp1024 y = root(Mp1024(2 * real * c * c + real * (real - 2)));
      return nearest(k, Mp1024((y - real) / (c - 1)),
                     [&](const Rational& m) { return Rational((m * m - 2 * b * m + 2 * b) / (m * m - 2 * b)); });
    }
    // Δ = (c + 1)²(2c − 1).
    return nearest(k, root(Mp1024(2 * c - 1)), [](const Rational& x) { return Rational((x * x + 1) / 2); });
  }

  /// The value of the function at the simplest number near x where it is near enough.
  template <class Function>
  [[nodiscard]] std::optional<Rational> nearest(size_t k, const Mp1024& x, const Function& value) const {
    constexpr int kMostBits = 400;
    constexpr unsigned kMostDigits = 2000;
    const Mp1024& wanted = *classes_[k].wanted;
    const Mp1024 margin = ldexp(wanted, -kBits);
    for (int bits = kBits - 4; bits <= kMostBits; bits += 4) {
      const Rational found = value(simplest_near(x, bits));
      if (abs(Mp1024(Mp1024(Rational(found - 1)) - wanted)) > margin) continue;
      return msb(numerator(found)) <= kMostDigits ? std::optional(found) : std::nullopt;
    }
    return std::nullopt;
  }

  [[nodiscard]] std::string root_of(const PantsType& type) {
    const LengthClass& a = classes_[type[0]];
    const LengthClass& b = classes_[type[1]];
    const LengthClass& c = classes_[type[2]];
    if (a.value && b.value && c.value) {
      const Rational square = discriminant(*a.value, *b.value, *c.value);
      if (const auto root = rational_root(square)) return text_of(*root);
      ++irrational_;
      bits_of_roots_ = std::max(bits_of_roots_, size_t{msb(numerator(square))});
      return "sqrt" + text_of(square);
    }
    ++irrational_;
    // Roots of algebraic integers have minimal polynomials with fewer digits.
    const Integer product = a.denominator * b.denominator * c.denominator;
    Integer scale = lcm(lcm(a.denominator, b.denominator), c.denominator);
    if (2 * scale * scale % product != 0) scale = product;
    const std::string square =
        a.text + "^2+" + b.text + "^2+" + c.text + "^2+2*" + a.text + "*" + b.text + "*" + c.text + "-1";
    return "(sqrt(" + scale.str() + "^2*(" + square + "))/" + scale.str() + ")";
  }

  std::vector<LengthClass> classes_;
  std::vector<size_t> class_of_edge_;
  std::vector<PantsType> type_of_pants_;
  std::set<PantsType> types_;
  std::vector<std::pair<PantsType, size_t>> solved_;  ///< In the order in which classes can be chosen.
  bool is_chosen_ = false;
  size_t irrational_ = 0;
  size_t bits_of_roots_ = 0;
};

/// tanh(twist/2)/sinh(length/2) of a twist that is rounded, to 2⁻⁵⁰ lengths.
Rational rounded_shift(const Mp1024& twist, const Mp1024& length, const Mp1024& sinh_of_half) {
  if (twist == 0) return 0;
  const Mp1024 half = abs(twist) / 2;
  const Mp1024 cosh_of_half = cosh(half);
  const Mp1024 value = tanh(half) / sinh_of_half;
  const Mp1024 margin = length / (2 * sinh_of_half * cosh_of_half * cosh_of_half * value);
  const Rational result = simplest_near(value, std::max(3, 51 - static_cast<int>(ilogb(margin))));
  return twist < 0 ? Rational(-result) : result;
}

std::string shift_text(const FenchelNielsen& coordinates, size_t e, const std::string& cosh) {
  const Rational share = share_of_twist(coordinates, e);
  if (share == 0) return "0";
  if (is_symmetric_share(share)) return "(-1/(1+" + cosh + "))";
  if (!coordinates.exact_twists.empty() && coordinates.exact_twists[e]) {
    const ExactLength& twist = *coordinates.exact_twists[e];
    const std::string c = cosh_text(twist, 1);
    const std::string sinh_squared = "(" + cosh + "^2-1)";
    const std::string root = "(sqrt((" + c + "^2-1)*" + sinh_squared + ")/((" + c + "+1)*" + sinh_squared + "))";
    return twist.times < 0 ? "(-" + root + ")" : root;
  }
  const Mp1024 c = real_value(cosh);
  const Mp1024 length(coordinates.lengths[e]);
  return text_of(rounded_shift(Mp1024(Mp1024(share) * length), length, Mp1024(sqrt(Mp1024(c * c - 1)))));
}

// ---- The surface ----

/// A number of the field of a reader.
struct AlgebraicNumber {
  const NumberFieldReader* field;
  RationalPolynomial value;
};

AlgebraicNumber operator+(AlgebraicNumber x, const AlgebraicNumber& y) {
  fmpq_poly_add(x.value.get(), x.value.get(), y.value.get());
  return x;
}
AlgebraicNumber operator-(AlgebraicNumber x, const AlgebraicNumber& y) {
  fmpq_poly_sub(x.value.get(), x.value.get(), y.value.get());
  return x;
}
AlgebraicNumber operator-(AlgebraicNumber x) {
  fmpq_poly_neg(x.value.get(), x.value.get());
  return x;
}
AlgebraicNumber operator*(const AlgebraicNumber& x, const AlgebraicNumber& y) {
  return {x.field, x.field->product(x.value, y.value)};
}

Mp1024 real(const AlgebraicNumber& x) {
  Mp1024 result;
  const certify::Ball value = x.field->value(x.value);
  arf_get_mpfr(result.backend().data(), arb_midref(value.get()), MPFR_RNDN);
  return result;
}

/// A matrix of PGL₂ of the field, with positive determinant, acting on the upper half-plane.
struct AlgebraicMatrix {
  AlgebraicNumber a, b, c, d;
};

AlgebraicMatrix operator*(const AlgebraicMatrix& m, const AlgebraicMatrix& n) {
  return {m.a * n.a + m.b * n.c, m.a * n.b + m.b * n.d, m.c * n.a + m.d * n.c, m.c * n.b + m.d * n.d};
}

/// Returns the inverse up to a factor.
AlgebraicMatrix inverse(const AlgebraicMatrix& m) { return {m.d, -m.b, -m.c, m.a}; }

/// The point z of the half-plane as the symmetric matrix (|z|² Re z; Re z 1), up to a positive factor.
struct PlanePoint {
  AlgebraicNumber a, b, c;
};

/// The image is m p mᵀ.
PlanePoint moved(const AlgebraicMatrix& m, const PlanePoint& p) {
  const AlgebraicNumber first_a = m.a * p.a + m.b * p.b;
  const AlgebraicNumber first_b = m.a * p.b + m.b * p.c;
  const AlgebraicNumber second_a = m.c * p.a + m.d * p.b;
  const AlgebraicNumber second_b = m.c * p.b + m.d * p.c;
  return {first_a * m.a + first_b * m.b, first_a * m.c + first_b * m.d, second_a * m.c + second_b * m.d};
}

/// Numbers times a common positive number, as integers without a common factor.
template <size_t n>
std::array<std::vector<mpz_class>, n> integers(const std::array<AlgebraicNumber, n>& numbers) {
  mpz_class denominator = 1;
  for (const AlgebraicNumber& x : numbers) denominator = lcm(denominator, denominator_of(x.value));
  std::array<std::vector<mpz_class>, n> result;
  mpz_class factor = 0;
  for (size_t k = 0; k < n; ++k) {
    const mpz_class scale = denominator / denominator_of(numbers[k].value);
    for (slong i = 0; i < fmpq_poly_length(numbers[k].value.get()); ++i) {
      certify::Integer coefficient;
      fmpz_set(coefficient.get(), fmpq_poly_numref(numbers[k].value.get()) + i);
      result[k].push_back(scale * coefficient.value());
      factor = gcd(factor, result[k].back());
    }
    if (result[k].empty()) result[k].emplace_back(0);
  }
  for (auto& coefficients : result) {
    for (mpz_class& x : coefficients) x /= factor;
  }
  return result;
}

/// A pair of pants. On cuff k the frame takes the half-plane, where the cuff is |z| = sinh(length/2), the pants beyond
/// it, and the mark above 0, to the coordinates of the pants.
struct FramedPants {
  std::array<AlgebraicMatrix, 3> frame;
  std::array<AlgebraicMatrix, 3> turn;  ///< In the frame: by the length along the cuff, with the pants on the left.
};

class PantsBuilder {
 public:
  PantsBuilder(const FenchelNielsen& coordinates, const PantsNumbers& numbers) : coordinates_(coordinates) {
    for (const auto* texts : {&numbers.cosh, &numbers.root, &numbers.shift}) {
      for (const std::string& text : *texts) reader_.add(text);
    }
    const PantsGraph& graph = coordinates.graph;
    for (std::uint32_t p = 0; p < graph.pants_count(); ++p) pants_.push_back(pants(p));
    set_base_points();
  }

  [[nodiscard]] Surface surface() const {
    std::vector<Gluing> gluing;
    std::vector<AlgebraicMatrix> crossings;
    for (std::uint32_t p = 0; p < pants_.size(); ++p) {
      const AlgebraicMatrix first = generator(p, 0);
      const AlgebraicMatrix second = generator(p, 1);
      gluing.push_back({p, 0, p, 2});
      crossings.push_back(second);
      gluing.push_back({p, 3, p, 5});
      crossings.push_back(inverse(first) * inverse(second));
    }
    for (size_t e = 0; e < coordinates_.graph.edges().size(); ++e) {
      const auto& [first, second] = coordinates_.graph.edges()[e];
      gluing.push_back({first.pants, kCuffSide[first.cuff], second.pants, kCuffSide[second.cuff]});
      crossings.push_back(end_frame(second) * inverse(turn(second)) * inverse(joint(e)) * inverse(end_frame(first)));
    }
    return is_rational() ? rational_surface(std::move(gluing)) : field_surface(std::move(gluing), crossings);
  }

 private:
  /// The sides of the heptagon that lie on the cuffs.
  static constexpr std::array<std::uint32_t, 3> kCuffSide{6, 1, 4};

  [[nodiscard]] bool is_rational() const { return reader_.field().polynomial.size() == 2; }

  [[nodiscard]] AlgebraicNumber number(size_t i) const { return {&reader_, reader_.numbers()[i]}; }
  [[nodiscard]] AlgebraicNumber cosh(size_t e) const { return number(e); }
  [[nodiscard]] AlgebraicNumber root(std::uint32_t p) const { return number(coordinates_.graph.edges().size() + p); }
  [[nodiscard]] AlgebraicNumber shift(size_t e) const {
    return number(coordinates_.graph.edges().size() + pants_count() + e);
  }
  [[nodiscard]] size_t pants_count() const { return coordinates_.graph.pants_count(); }
  [[nodiscard]] AlgebraicNumber constant(const Rational& x) const { return {&reader_, epsnet::constant(to_gmp(x))}; }
  [[nodiscard]] AlgebraicNumber squared_sinh(size_t e) const { return cosh(e) * cosh(e) - constant(1); }

  /// Moves along the circle |z| = s by the distance with this tanh of its half, divided by s.
  [[nodiscard]] AlgebraicMatrix along(size_t e, const AlgebraicNumber& tanh_by_sinh) const {
    return {constant(1), squared_sinh(e) * tanh_by_sinh, tanh_by_sinh, constant(1)};
  }

  [[nodiscard]] FramedPants pants(std::uint32_t p) const {
    const PantsGraph& graph = coordinates_.graph;
    const std::array<size_t, 3> edge{graph.edge_at(p, 0), graph.edge_at(p, 1), graph.edge_at(p, 2)};
    // w = s s′ exp(distance of two cuffs): z ↦ −w/z takes the frame of the one to that of the other, where its mark
    // would be if the seam between them ended there.
    const auto across = [&](size_t k, size_t l, size_t m) {
      const AlgebraicNumber w = cosh(edge[k]) * cosh(edge[l]) + cosh(edge[m]) + root(p);
      return AlgebraicMatrix{constant(0), -w, constant(1), constant(0)};
    };
    // By half of the length, to the end of the other seam.
    const auto half = [&](size_t k) {
      const AlgebraicNumber c = cosh(edge[k]) + constant(1);
      return AlgebraicMatrix{c, squared_sinh(edge[k]), constant(1), c};
    };
    const AlgebraicMatrix second = across(0, 1, 2);
    // Cuffs 0 and 1 are to be around i.
    constexpr int kRough = 3;
    const Mp1024 height =
        sqrt(Mp1024(sqrt(real(squared_sinh(edge[0]))) * -real(second.b) / sqrt(real(squared_sinh(edge[1])))));
    const AlgebraicMatrix scale{constant(1), constant(0), constant(0), constant(simplest_near(height, kRough))};
    FramedPants result{{scale, scale * second * inverse(half(1)), scale * half(0) * across(2, 0, 1)}, {}};
    for (size_t k = 0; k < 3; ++k) {
      const AlgebraicNumber c = cosh(edge[k]);
      result.turn[k] = {c, squared_sinh(edge[k]), constant(1), c};
    }
    return result;
  }

  [[nodiscard]] const AlgebraicMatrix& turn(PantsGraph::End end) const { return pants_[end.pants].turn[end.cuff]; }

  [[nodiscard]] AlgebraicMatrix generator(std::uint32_t p, size_t k) const {
    return pants_[p].frame[k] * pants_[p].turn[k] * inverse(pants_[p].frame[k]);
  }

  /// The frame that takes the base point of a cuff to the end of its side of the heptagon.
  [[nodiscard]] AlgebraicMatrix end_frame(PantsGraph::End end) const {
    const AlgebraicMatrix& frame = pants_[end.pants].frame[end.cuff];
    if (end.cuff == 0) return frame;
    const AlgebraicMatrix turned = frame * turn(end);
    return end.cuff == 1 ? turned : generator(end.pants, 1) * turned;
  }

  /// From the frame on the second side of an edge to that on the first: around the mark to the other side, and along
  /// the cuff.
  [[nodiscard]] AlgebraicMatrix joint(size_t e) const {
    return along(e, shift(e)) * AlgebraicMatrix{constant(0), -squared_sinh(e), constant(1), constant(0)};
  }

  /// In the frames. Between the marks: on the cuff, but for rational tiles near it, as the cuff may have no rational
  /// points.
  void set_base_points() {
    base_.resize(pants_count());
    for (size_t e = 0; e < coordinates_.graph.edges().size(); ++e) {
      const auto& [first, second] = coordinates_.graph.edges()[e];
      const Mp1024 sinh_of_half = sqrt(real(squared_sinh(e)));
      const Mp1024 half_twist = atanh(Mp1024(real(shift(e)) * sinh_of_half));
      PlanePoint point{squared_sinh(e), constant(0), constant(1)};
      if (is_rational()) {
        // Near in comparison with the cuff, if it is short, and with the angles at its ends, if it is long.
        const Mp1024 length(coordinates_.lengths[e]);
        const int bits = 64 + 4 * std::abs(static_cast<int>(ilogb(length))) + static_cast<int>(4 * length);
        const Rational x = half_twist == 0 ? Rational(0) : signed_near(Mp1024(sinh_of_half * tanh(half_twist)), bits);
        const Rational y = simplest_near(Mp1024(sinh_of_half / Mp1024(boost::multiprecision::cosh(half_twist))), bits);
        point = {constant(x * x + y * y), constant(x), constant(1)};
      } else if (half_twist != 0) {
        constexpr int kRough = 6;
        point =
            moved(along(e, constant(signed_near(Mp1024(tanh(Mp1024(half_twist / 2)) / sinh_of_half), kRough))), point);
      }
      base_[first.pants].push_back({first.cuff, point});
      base_[second.pants].push_back({second.cuff, moved(inverse(joint(e)), point)});
    }
  }

  static Rational signed_near(const Mp1024& x, int bits) {
    const Rational size = simplest_near(Mp1024(abs(x)), bits);
    return x < 0 ? Rational(-size) : size;
  }

  [[nodiscard]] const PlanePoint& base(std::uint32_t p, std::uint32_t k) const {
    const auto at = std::find_if(base_[p].begin(), base_[p].end(), [&](const auto& x) { return x.first == k; });
    return at->second;
  }

  /// The corners P1, P2, D2 P2, D2 P1, D2 P3, D1⁻¹ P3, D1⁻¹ P1, as vectors of Minkowski space.
  [[nodiscard]] std::vector<std::array<std::vector<mpz_class>, 3>> heptagon(std::uint32_t p) const {
    std::array<PlanePoint, 3> at{moved(pants_[p].frame[0], base(p, 0)), moved(pants_[p].frame[1], base(p, 1)),
                                 moved(pants_[p].frame[2], base(p, 2))};
    const AlgebraicMatrix second = generator(p, 1);
    const AlgebraicMatrix back = inverse(generator(p, 0));
    std::vector<std::array<std::vector<mpz_class>, 3>> result;
    for (const PlanePoint& z : {at[0], at[1], moved(second, at[1]), moved(second, at[0]), moved(second, at[2]),
                                moved(back, at[2]), moved(back, at[0])}) {
      result.push_back(integers(std::array<AlgebraicNumber, 3>{z.a - z.c, -(z.b + z.b), z.a + z.c}));
    }
    return result;
  }

  [[nodiscard]] Surface rational_surface(std::vector<Gluing> gluing) const {
    std::vector<Tile> tiles;
    for (std::uint32_t p = 0; p < pants_count(); ++p) {
      Tile& tile = tiles.emplace_back();
      for (const auto& v : heptagon(p)) {
        const auto at = [&](size_t k) { return from_gmp(mpq_class(v[k][0])); };
        const Rational height = rational_root(Rational(at(2) * at(2) - at(0) * at(0) - at(1) * at(1))).value();
        tile.push_back({at(0) / (at(2) + height), at(1) / (at(2) + height)});
      }
    }
    return {std::move(tiles), std::move(gluing)};
  }

  [[nodiscard]] Surface field_surface(std::vector<Gluing> gluing, const std::vector<AlgebraicMatrix>& crossings) const {
    certify::SurfaceDocument::Field tiles = reader_.field();
    for (std::uint32_t p = 0; p < pants_count(); ++p) tiles.polygons.push_back(heptagon(p));
    for (const AlgebraicMatrix& m : crossings) {
      // w = (z − i)/(z + i) takes the half-plane to the disk.
      tiles.crossings.push_back(
          integers(std::array<AlgebraicNumber, 4>{m.a + m.d, m.b - m.c, m.a - m.d, -(m.b + m.c)}));
    }
    return surface_over_field(std::move(tiles), std::move(gluing));
  }

  const FenchelNielsen& coordinates_;
  NumberFieldReader reader_;
  std::vector<FramedPants> pants_;
  std::vector<std::vector<std::pair<std::uint32_t, PlanePoint>>> base_;
};

std::string about(const FenchelNielsen& coordinates, const PantsNumbers& numbers) {
  // A file has room for 1 MiB of text (docs/format.md).
  constexpr size_t kMostText = (size_t{1} << 20) - 64;
  std::string result =
      "Fenchel-Nielsen, exactly: per edge the two pants with their cuffs, c = cosh(length/2), "
      "u = tanh(twist/2)/sinh(length/2)";
  for (size_t e = 0; e < numbers.cosh.size(); ++e) {
    const auto& [first, second] = coordinates.graph.edges()[e];
    const auto name = [](PantsGraph::End end) { return std::to_string(end.pants) + "." + std::to_string(end.cuff); };
    const std::string used =
        "; " + name(first) + "-" + name(second) + " c=" + numbers.cosh[e] + " u=" + numbers.shift[e];
    if (result.size() + used.size() > kMostText) {
      return result + "; and " + std::to_string(numbers.cosh.size() - e) + " more edges";
    }
    result += used;
  }
  return result;
}

}  // namespace

std::optional<PantsNumbers> pants_numbers(const FenchelNielsen& coordinates) {
  PantsNumbers result;
  constexpr size_t kMostRoots = 3;
  // Numbers of a field have about as many as the degree times this.
  constexpr size_t kMostBits = 6000;
  const bool is_exact = !coordinates.exact_lengths.empty() || !coordinates.exact_twists.empty();
  const LengthChooser chooser(coordinates, is_exact ? coordinates.lengths.size() : kMostRoots, result);
  if (!chooser.is_chosen()) return std::nullopt;
  const size_t roots = chooser.irrational();
  if (!is_exact && (roots > kMostRoots || chooser.bits_of_roots() << roots > kMostBits)) return std::nullopt;
  for (size_t e = 0; e < result.cosh.size(); ++e) result.shift.push_back(shift_text(coordinates, e, result.cosh[e]));
  return result;
}

Surface surface_of_pants(const FenchelNielsen& coordinates, const PantsNumbers& numbers) {
  try {
    Surface result = PantsBuilder(coordinates, numbers).surface();
    result.set_about(about(coordinates, numbers));
    return result;
  } catch (const SurfaceError& error) {
    throw SurfaceError("these lengths and twists cannot be exact: " + std::string(error.what()));
  }
}

}  // namespace epsnet
