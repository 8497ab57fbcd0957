// Numbers for people. An interval that is proved stays in the file and in the certificate; here it is as many digits as are certain.

const kMostDigits = 12;

// 10¹⁸
const superscript = n => [...String(n)].map(c => '⁻⁰¹²³⁴⁵⁶⁷⁸⁹'['-0123456789'.indexOf(c)]).join('');
// λ₁₂
export const subscript = n => [...String(n)].map(digit => '₀₁₂₃₄₅₆₇₈₉'[digit]).join('');

// The least number of one digit that is not smaller, up to rounding: "3e-70".
function roundedUp(x) {
  const [digit, exponent] = x.toExponential(1).split('e');
  return String(Number(`${Math.ceil(Number(digit) + 0.05)}e${exponent}`));
}

// A number with the digits that its enclosure determines, at most 12; the enclosure itself if these are fewer than three; what is about 0 as 0 ± 1e-70.
export function number([lower, upper]) {
  if (lower === null || upper === null) return `in [${lower ?? '−∞'}, ${upper ?? '∞'}]`;
  if (lower <= 0 && upper >= 0 && upper - lower < 1e-12) return lower === upper ? '0' : `0 ± ${roundedUp(Math.max(-lower, upper))}`;
  if (lower === upper && String(lower).length <= kMostDigits) return String(lower);
  for (let digits = kMostDigits; digits >= 3; --digits) {
    const text = Number(lower).toPrecision(digits);
    if (text === Number(upper).toPrecision(digits)) return String(Number(text));
  }
  return `in [${lower}, ${upper}]`;
}

// A fraction such as "-19499/32768", rounded to 12 digits after the point.
export function decimal(fraction) {
  const [numerator, denominator] = [...fraction.split('/'), '1'].map(BigInt), twelve = 10n ** 12n;
  const size = numerator < 0n ? -numerator : numerator, rounded = (2n * size * twelve + denominator) / (2n * denominator);
  return String(Number(`${numerator < 0n ? '-' : ''}${rounded}e-12`));
}

// "21 × 3.93594624883", for each of the numbers in their order; those whose enclosures meet are one line.
export function grouped(enclosures) {
  const groups = [];
  for (const [lower, upper] of enclosures) {
    const last = groups.at(-1);
    if (last !== undefined && lower <= last.upper && last.lower <= upper) {
      Object.assign(last, {lower: Math.min(last.lower, lower), upper: Math.max(last.upper, upper), count: last.count + 1});
    } else {
      groups.push({lower, upper, count: 1});
    }
  }
  return groups.map(({lower, upper, count}) => (count > 1 ? `${count} × ` : '') + number([lower, upper]));
}

// A large number, roughly: "450,000", "3.2 million", "4.3 · 10¹⁸".
export function rough(n) {
  if (n < 1e6) return Math.round(n).toLocaleString('en');
  if (n < 1e9) return `${Math.round(n / 1e5) / 10} million`;
  const [mantissa, exponent] = n.toExponential(1).split('e');
  return `${mantissa} · 10${superscript(Number(exponent))}`;
}
