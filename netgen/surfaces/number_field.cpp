#include "netgen/surfaces/number_field.h"

#if __has_include(<flint/arb_fmpz_poly.h>)
#include <flint/arb_fmpz_poly.h>
#else
#include <arb_fmpz_poly.h>
#endif
#include <algorithm>
#include <flint/fmpq_mat.h>
#ifndef __EMSCRIPTEN__
#include <flint/fmpz_poly_factor.h>
#endif
#include <optional>
#include <string>

#include "certify/numbers/field_number.h"
#include "triangulation/surface/surface.h"

namespace epsnet {
namespace {

using certify::Polynomial;

/// Of the values of numbers: far more than tells a number from 0 that a person writes.
constexpr slong kValueBits = 4096;

struct RationalType {
  using Struct = fmpq;
  static void init(fmpq* x) { fmpq_init(x); }
  static void set(fmpq* x, const fmpq* y) { fmpq_set(x, y); }
  static void swap(fmpq* x, fmpq* y) { fmpq_swap(x, y); }
  static void clear(fmpq* x) { fmpq_clear(x); }
};
using FlintRational = certify::Owner<RationalType>;

mpq_class coefficient(const RationalPolynomial& x, slong k) {
  FlintRational value;
  fmpq_poly_get_coeff_fmpq(value.get(), x.get(), k);
  mpq_class result;
  fmpq_get_mpq(result.get_mpq_t(), value.get());
  return result;
}

}  // namespace

RationalPolynomial constant(const mpq_class& x) {
  RationalPolynomial result;
  FlintRational value;
  fmpq_set_mpq(value.get(), x.get_mpq_t());
  fmpq_poly_set_coeff_fmpq(result.get(), 0, value.get());
  return result;
}

namespace {

bool is_zero(const RationalPolynomial& x) { return fmpq_poly_is_zero(x.get()) != 0; }
bool is_constant(const RationalPolynomial& x) { return fmpq_poly_degree(x.get()) <= 0; }

RationalPolynomial to_rational(const Polynomial& x) {
  RationalPolynomial result;
  fmpq_poly_set_fmpz_poly(result.get(), x.get());
  return result;
}

/// A multiple without fractions.
Polynomial integral(const RationalPolynomial& x) {
  Polynomial result;
  fmpq_poly_get_numerator(result.get(), x.get());
  return result;
}

RationalPolynomial sum(RationalPolynomial x, const RationalPolynomial& y) {
  fmpq_poly_add(x.get(), x.get(), y.get());
  return x;
}

RationalPolynomial negative(RationalPolynomial x) {
  fmpq_poly_neg(x.get(), x.get());
  return x;
}

/// The bits of a number that is read; a person writes some hundred.
constexpr std::uint64_t kMostBits = 100'000;

std::uint64_t size_of(const RationalPolynomial& x) {
  return certify::bits_of_coefficients(integral(x)) + mpz_sizeinbase(denominator_of(x).get_mpz_t(), 2);
}

RationalPolynomial product_of(const RationalPolynomial& x, const RationalPolynomial& y) {
  if (size_of(x) + size_of(y) > kMostBits) {
    throw SurfaceError("a number of more than " + std::to_string(kMostBits) + " bits");
  }
  RationalPolynomial result;
  fmpq_poly_mul(result.get(), x.get(), y.get());
  return result;
}

RationalPolynomial remainder(const RationalPolynomial& x, const Polynomial& f) {
  RationalPolynomial result;
  fmpq_poly_rem(result.get(), x.get(), to_rational(f).get());
  return result;
}

certify::Ball evaluated(const Polynomial& x, const certify::Ball& at) {
  certify::Ball result;
  arb_fmpz_poly_evaluate_arb(result.get(), x.get(), at.get(), kValueBits);
  return result;
}

/// The real roots of a polynomial without multiple ones, in balls that are apart.
std::vector<certify::Ball> real_roots(const Polynomial& f) {
  const slong degree = fmpz_poly_degree(f.get());
  acb_ptr roots = _acb_vec_init(degree);
  arb_fmpz_poly_complex_roots(roots, f.get(), 0, kValueBits);
  std::vector<certify::Ball> result;
  for (slong i = 0; i < degree; ++i) {
    if (arb_is_zero(acb_imagref(roots + i)) != 0) result.emplace_back(acb_realref(roots + i));
  }
  _acb_vec_clear(roots, degree);
  return result;
}

/// The irreducible factors of a polynomial, each once.
#ifdef __EMSCRIPTEN__
std::vector<Polynomial> factors_of(const Polynomial& /*f*/) {
  // It takes 2,000 files of FLINT.
  throw LimitError(
      "polynomials over the rationals are factored by the program epsnet, not in a browser: see docs/wasm.md");
}
#else
std::vector<Polynomial> factors_of(const Polynomial& f) {
  fmpz_poly_factor_t factors;
  fmpz_poly_factor_init(factors);
  fmpz_poly_factor(factors, f.get());
  std::vector<Polynomial> result(static_cast<std::size_t>(factors->num));
  for (std::size_t i = 0; i < result.size(); ++i) fmpz_poly_set(result[i].get(), factors->p + i);
  fmpz_poly_factor_clear(factors);
  return result;
}
#endif

/// Numbers of K[t]/(p) for the polynomial p of degree m over K = ℚ(α): polynomials in t of less degree.
using Extended = std::vector<RationalPolynomial>;

/// The rows are coordinates of some numbers, for which x_k = Σ c_i row_i is solved; false if they are dependent.
class Coordinates {
 public:
  explicit Coordinates(slong size) : size_(size) {
    fmpq_mat_init(rows_, size, size);
    fmpq_mat_init(wanted_, size, 3);
    fmpq_mat_init(solution_, size, 3);
  }
  Coordinates(const Coordinates&) = delete;
  Coordinates& operator=(const Coordinates&) = delete;
  ~Coordinates() {
    fmpq_mat_clear(rows_);
    fmpq_mat_clear(wanted_);
    fmpq_mat_clear(solution_);
  }

  void set_row(slong i, const Extended& x) { set(rows_, i, x); }
  void set_wanted(slong k, const Extended& x) { set(wanted_, k, x); }
  [[nodiscard]] bool solve() { return fmpq_mat_solve(solution_, rows_, wanted_) != 0; }
  [[nodiscard]] RationalPolynomial solution(slong k) const {
    RationalPolynomial result;
    for (slong i = 0; i < size_; ++i) fmpq_poly_set_coeff_fmpq(result.get(), i, fmpq_mat_entry(solution_, i, k));
    return result;
  }

 private:
  /// Column i, by the degrees in α and t.
  void set(fmpq_mat_t matrix, slong column, const Extended& x) const {
    const slong degree = size_ / static_cast<slong>(x.size());
    for (std::size_t j = 0; j < x.size(); ++j) {
      for (slong i = 0; i < degree; ++i) {
        fmpq_poly_get_coeff_fmpq(fmpq_mat_entry(matrix, static_cast<slong>(j) * degree + i, column), x[j].get(), i);
      }
    }
  }

  slong size_;
  fmpq_mat_t rows_;
  fmpq_mat_t wanted_;
  fmpq_mat_t solution_;
};

/// The polynomial in `inner` that x is, both modulo f; inner generates the field.
RationalPolynomial expressed(const RationalPolynomial& x, const RationalPolynomial& inner, const Polynomial& f) {
  const slong degree = fmpz_poly_degree(f.get());
  Coordinates coordinates(degree);
  RationalPolynomial power = constant(1);
  for (slong i = 0; i < degree; ++i) {
    coordinates.set_row(i, {power});
    power = remainder(product_of(power, inner), f);
  }
  for (slong k = 0; k < 3; ++k) coordinates.set_wanted(k, {x});
  if (!coordinates.solve()) throw SurfaceError("a number does not generate its field");
  return coordinates.solution(0);
}

/// A positive integer whose n-th power is a multiple of x; the least one, if the prime factors of x that are not small
/// make an n-th power.
mpz_class root_of_multiple(mpz_class x, unsigned long n) {
  constexpr unsigned long kSmall = 100;
  mpz_class result = 1;
  for (unsigned long prime = 2; prime < kSmall; ++prime) {
    unsigned long exponent = 0;
    for (; mpz_divisible_ui_p(x.get_mpz_t(), prime) != 0; ++exponent) x /= prime;
    for (unsigned long i = 0; i < exponent; i += n) result *= prime;
  }
  mpz_class root;
  return result * (mpz_root(root.get_mpz_t(), x.get_mpz_t(), n) != 0 ? root : x);
}

/// A positive integer times which a root of t^m + p[m − 1] t^(m−1) + … is an algebraic integer, if the p are rational:
/// the minimal polynomials of others have more digits. Of the others of a field the denominators say little.
mpz_class integral_multiple(const std::vector<RationalPolynomial>& p) {
  mpz_class result = 1;
  if (!std::all_of(p.begin(), p.end(), is_constant)) return result;
  for (std::size_t j = 0; j < p.size(); ++j) {
    result = lcm(result, root_of_multiple(denominator_of(p[j]), p.size() - j));
  }
  return result;
}

/// The field became larger: what was read before means something else now.
struct Adjoined {};

}  // namespace

/// Reads one number, and has its reader adjoin what is missing.
class NumberFieldParser : public ArithmeticParser<RationalPolynomial> {
 public:
  NumberFieldParser(std::string_view text, NumberFieldReader& reader) : ArithmeticParser(text), reader_(reader) {}

 private:
  RationalPolynomial constant(const mpq_class& x) override { return epsnet::constant(x); }
  RationalPolynomial negative(RationalPolynomial x) override { return epsnet::negative(std::move(x)); }
  RationalPolynomial sum(RationalPolynomial x, const RationalPolynomial& y) override {
    return epsnet::sum(std::move(x), y);
  }
  /// In a polynomial x is a variable, and nothing is reduced.
  RationalPolynomial product(const RationalPolynomial& x, const RationalPolynomial& y) override {
    return in_polynomial_ ? product_of(x, y) : reader_.product(x, y);
  }
  RationalPolynomial quotient(const RationalPolynomial& x, const RationalPolynomial& y) override {
    if (is_zero(y)) fail("a number other than 0 before this");
    if (!in_polynomial_) return reader_.quotient(x, y);
    if (!is_constant(y)) fail("a number before this");
    return product_of(x, epsnet::constant(1 / coefficient(y, 0)));
  }
  std::string expected_number() const override {
    return in_polynomial_ ? "a number or x" : "a number, sqrt(x), root(f,r), cos(a*pi/b) or sin(a*pi/b)";
  }

  std::optional<RationalPolynomial> named_number() override {
    if (in_polynomial_) {
      if (!take("x")) return std::nullopt;
      RationalPolynomial x;
      fmpq_poly_set_coeff_si(x.get(), 1, 1);
      return x;
    }
    const std::size_t first = place();
    if (take("sqrt(")) return root_of_number(first);
    if (take("root(")) return root_of_polynomial(first);
    if (take("cos(")) return cosine_of(angle());
    if (take("sin(")) return cosine_of(mpq_class(1, 2) - angle());
    return std::nullopt;
  }

  /// The number with this name. Throws Adjoined after it was adjoined, if it is not known.
  RationalPolynomial named(const std::string& name, const std::vector<RationalPolynomial>& polynomial,
                           const certify::Ball& value) {
    for (const auto& known : reader_.named_) {
      if (known.name == name) return known.value;
    }
    const RationalPolynomial result = reader_.adjoined(polynomial, value);
    reader_.named_.push_back({name, result});
    throw Adjoined();
  }

  RationalPolynomial root_of_number(std::size_t first) {
    RationalPolynomial square = sum_of_products();
    expect(")");
    if (is_zero(square)) return square;
    const certify::Ball value = reader_.value(square);
    if (certify::certainly_positive(value) != certify::Tri::yes)
      fail("a positive number in the square root before this");
    const certify::Precision scope(kValueBits);
    return named(text_from(first), {negative(square), constant(0)}, sqrt(value));
  }

  RationalPolynomial root_of_polynomial(std::size_t first) {
    in_polynomial_ = true;
    const RationalPolynomial f = sum_of_products();
    in_polynomial_ = false;
    if (fmpq_poly_degree(f.get()) < 1 || fmpq_poly_degree(f.get()) > NumberFieldReader::kMostDegree) {
      fail("a polynomial in x of degree 1 to 64 before this");
    }
    if (size_of(f) * static_cast<std::uint64_t>(fmpq_poly_length(f.get())) > kMostBits) {
      fail("a polynomial of at most " + std::to_string(kMostBits) + " bits before this");
    }
    expect(",");
    const mpq_class sign = take("-") ? -1 : 1;
    const mpq_class near = sign * decimal();
    expect(")");
    const certify::Precision scope(kValueBits);
    struct Root {
      certify::Ball value;
      certify::Ball distance;
      Polynomial factor;
    };
    std::vector<Root> roots;
    for (const Polynomial& factor : factors_of(integral(f))) {
      for (const certify::Ball& root : real_roots(factor))
        roots.push_back({root, abs(root - certify::Ball::rounded(near)), factor});
    }
    if (roots.empty()) fail("a polynomial that has a real root before this");
    const auto is_nearest = [&](const Root& root) {
      return std::all_of(roots.begin(), roots.end(), [&](const Root& other) {
        return &other == &root || certify::certainly_less(root.distance, other.distance) == certify::Tri::yes;
      });
    };
    const auto nearest = std::find_if(roots.begin(), roots.end(), is_nearest);
    if (nearest == roots.end()) fail("a decimal that is nearer to one root than to the others before this");
    return named(text_from(first), monic(nearest->factor), nearest->value);
  }

  static std::vector<RationalPolynomial> monic(const Polynomial& f) {
    const RationalPolynomial rational = to_rational(f);
    const slong degree = fmpz_poly_degree(f.get());
    std::vector<RationalPolynomial> result;
    for (slong i = 0; i < degree; ++i)
      result.push_back(epsnet::constant(coefficient(rational, i) / coefficient(rational, degree)));
    return result;
  }

  /// Of a multiple of π: half of a root of the minimal polynomial of 2cos(2π/n).
  RationalPolynomial cosine_of(const mpq_class& times_pi) {
    mpq_class turns = times_pi / 2;
    turns.canonicalize();
    constexpr unsigned long kMostParts = 1000;
    if (turns.get_den() > kMostParts) fail("an angle of at most 500 parts of pi before this");
    const unsigned long n = turns.get_den().get_ui();
    Polynomial f;
    fmpz_poly_cos_minpoly(f.get(), n);
    FlintRational angle;
    fmpq_set_mpq(angle.get(), times_pi.get_mpq_t());
    certify::Ball value;
    arb_cos_pi_fmpq(value.get(), angle.get(), kValueBits);
    return product_of(epsnet::constant(mpq_class(1, 2)), named("cos " + turns.get_str(), monic(f), twice(value)));
  }

  NumberFieldReader& reader_;
  bool in_polynomial_ = false;
};

NumberFieldReader::NumberFieldReader() { fmpz_poly_set_coeff_si(f_.get(), 1, 1); }

void NumberFieldReader::add(std::string_view text) {
  while (true) {
    try {
      numbers_.push_back(NumberFieldParser(text, *this).read());
      return;
    } catch (const Adjoined&) {
      // Again, with one number more that has a name.
    }
  }
}

RationalPolynomial NumberFieldReader::product(const RationalPolynomial& x, const RationalPolynomial& y) const {
  return remainder(product_of(x, y), f_);
}

RationalPolynomial NumberFieldReader::quotient(const RationalPolynomial& x, const RationalPolynomial& y) const {
  // f is irreducible: s y + t f = 1.
  RationalPolynomial one;
  RationalPolynomial s;
  RationalPolynomial t;
  fmpq_poly_xgcd(one.get(), s.get(), t.get(), y.get(), to_rational(f_).get());
  return product(x, s);
}

certify::Ball NumberFieldReader::value(const RationalPolynomial& x) const {
  const certify::Precision scope(kValueBits);
  certify::Integer denominator;
  fmpq_poly_get_denominator(denominator.get(), x.get());
  return evaluated(integral(x), alpha_) / certify::Ball::rounded(denominator.value());
}

RationalPolynomial NumberFieldReader::adjoined(const std::vector<RationalPolynomial>& p, const certify::Ball& t) {
  const mpz_class scale = integral_multiple(p);
  std::vector<RationalPolynomial> scaled = p;
  mpz_class power = 1;
  for (auto x = scaled.rbegin(); x != scaled.rend(); ++x) {
    power *= scale;
    *x = product_of(*x, constant(power));
  }
  const certify::Precision scope(kValueBits);
  RationalPolynomial root = adjoined_integer(scaled, certify::Ball::rounded(scale) * t);
  return product_of(root, constant(mpq_class(1, scale)));
}

RationalPolynomial NumberFieldReader::adjoined_integer(const std::vector<RationalPolynomial>& p,
                                                       const certify::Ball& t) {
  const auto m = static_cast<slong>(p.size());
  const slong size = degree() * m;
  constexpr slong kMostSize = 2 * kMostDegree;
  if (size > kMostSize)
    throw SurfaceError("the numbers are in a field of degree " + std::to_string(size) + ", expected at most 64");
  RationalPolynomial alpha;
  fmpq_poly_set_coeff_si(alpha.get(), 1, 1);
  alpha = remainder(alpha, f_);
  const auto numbers = [&](const RationalPolynomial& first, const RationalPolynomial& second) {
    Extended result(p.size());
    result[0] = first;
    if (m > 1) result[1] = second;
    return result;
  };
  // θ = t + cα generates both but for few c.
  constexpr long kMostTrials = 100;
  for (long c = degree() == 1 ? 0 : 1; c < kMostTrials; ++c) {
    const RationalPolynomial shift = product_of(constant(c), alpha);
    const auto times_theta = [&](const Extended& x) {
      Extended result(x.size());
      for (std::size_t j = 0; j < x.size(); ++j) {
        result[j] = sum(product(shift, x[j]), j > 0 ? x[j - 1] : RationalPolynomial());
        result[j] = sum(std::move(result[j]), negative(product(x.back(), p[j])));
      }
      return result;
    };
    Coordinates coordinates(size);
    Extended power = numbers(constant(1), {});
    for (slong i = 0; i < size; ++i) {
      coordinates.set_row(i, power);
      power = times_theta(power);
    }
    coordinates.set_wanted(0, power);
    coordinates.set_wanted(1, numbers(alpha, {}));
    coordinates.set_wanted(2, m > 1 ? numbers({}, constant(1)) : numbers(negative(p[0]), {}));
    if (!coordinates.solve()) continue;
    // θ^size is this polynomial in θ.
    RationalPolynomial relation = negative(coordinates.solution(0));
    fmpq_poly_set_coeff_si(relation.get(), size, 1);
    const certify::Precision scope(kValueBits);
    const certify::Ball theta = t + c * alpha_;
    std::optional<Polynomial> least;  // That of θ.
    for (const Polynomial& factor : factors_of(integral(relation))) {
      if (arb_contains_zero(evaluated(factor, theta).get()) == 0) continue;
      if (least)
        throw SurfaceError("a number cannot be told from another one with " + std::to_string(kValueBits) + " bits");
      least = factor;
    }
    if (!least) throw SurfaceError("a number has no minimal polynomial that its decimals know");
    const RationalPolynomial alpha_in_theta = remainder(coordinates.solution(1), *least);
    RationalPolynomial root = remainder(coordinates.solution(2), *least);
    if (fmpz_poly_degree(least->get()) == degree()) return expressed(root, alpha_in_theta, *least);
    move_to(*least, theta, alpha_in_theta, root);
    return root;
  }
  throw SurfaceError("a number has a minimal polynomial with multiple roots");
}

void NumberFieldReader::move_to(const Polynomial& h, const certify::Ball& theta, const RationalPolynomial& alpha,
                                RationalPolynomial& also) {
  const slong degree = fmpz_poly_degree(h.get());
  if (degree > kMostDegree)
    throw SurfaceError("the numbers are in a field of degree " + std::to_string(degree) + ", expected at most 64");
  // The new α is lθ, an algebraic integer, for the leading coefficient l: l^(degree − 1) h(α/l) is monic.
  certify::Integer lead;
  fmpz_poly_get_coeff_fmpz(lead.get(), h.get(), degree);
  Polynomial monic;
  certify::Integer factor;
  fmpz_one(factor.get());
  fmpz_poly_set_coeff_si(monic.get(), degree, 1);
  for (slong i = degree - 1; i >= 0; --i) {
    certify::Integer coefficient;
    fmpz_poly_get_coeff_fmpz(coefficient.get(), h.get(), i);
    fmpz_mul(coefficient.get(), coefficient.get(), factor.get());
    fmpz_poly_set_coeff_fmpz(monic.get(), i, coefficient.get());
    fmpz_mul(factor.get(), factor.get(), lead.get());
  }
  f_ = monic;
  const certify::Precision scope(kValueBits);
  alpha_ = certify::Ball::rounded(lead.value()) * theta;
  RationalPolynomial theta_now;
  fmpq_poly_set_coeff_si(theta_now.get(), 1, 1);
  fmpq_poly_scalar_div_fmpz(theta_now.get(), theta_now.get(), lead.get());
  theta_now = remainder(theta_now, f_);
  const auto composed = [&](const RationalPolynomial& outer, const RationalPolynomial& inner) {
    // Horner's scheme, reduced after each step.
    RationalPolynomial result;
    for (slong i = fmpq_poly_degree(outer.get()); i >= 0; --i) {
      result = sum(product(result, inner), constant(coefficient(outer, i)));
    }
    return result;
  };
  const RationalPolynomial alpha_now = composed(alpha, theta_now);
  also = composed(also, theta_now);
  for (Named& known : named_) known.value = composed(known.value, alpha_now);
  for (RationalPolynomial& number : numbers_) number = composed(number, alpha_now);
}

certify::SurfaceDocument::Field NumberFieldReader::field() const {
  certify::SurfaceDocument::Field result;
  for (slong i = 0; i <= degree(); ++i) {
    certify::Integer coefficient;
    fmpz_poly_get_coeff_fmpz(coefficient.get(), f_.get(), i);
    result.polynomial.push_back(coefficient.value());
  }
  // As short an interval with as few digits as is needed.
  for (slong bits = 0;; ++bits) {
    certify::Integer floor;
    const certify::Precision scope(kValueBits);
    certify::Ball scaled_alpha = scaled(alpha_, bits);
    arf_get_fmpz(floor.get(), arb_midref(scaled_alpha.get()), ARF_RND_FLOOR);
    const mpz_class scale = mpz_class(1) << static_cast<mp_bitcnt_t>(bits);
    result.root = {mpq_class(mpz_class(floor.value() - 1), scale), mpq_class(mpz_class(floor.value() + 2), scale)};
    for (mpq_class& end : result.root) end.canonicalize();
    const auto& [lower, upper] = result.root;
    if (certify::count_roots(result.polynomial, lower, upper).changes == 1) return result;
  }
}

std::string polynomial_text(const std::vector<mpz_class>& coefficients, const std::string& name) {
  std::string text;
  for (std::size_t k = coefficients.size(); k-- > 0;) {
    const mpz_class& c = coefficients[k];
    if (c == 0) continue;
    if (c > 0 && !text.empty()) text += "+";
    if (k == 0 || abs(c) != 1) {
      text += c.get_str() + (k > 0 ? "*" : "");
    } else if (c < 0) {
      text += "-";
    }
    if (k > 0) text += name + (k > 1 ? "^" + std::to_string(k) : "");
  }
  return text.empty() ? "0" : text;
}

}  // namespace epsnet
