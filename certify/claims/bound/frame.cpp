#include "certify/claims/bound/frame.h"

namespace epsnet::certify {
namespace {

Frame::Point in_binary64(const BallVector& x) {
  return {fast_interval(x[0]), fast_interval(x[1]), fast_interval(x[2])};
}

Interval dot(const Frame::Point& row, const Frame::Point& x) { return row[0] * x[0] + row[1] * x[1] + row[2] * x[2]; }

/// The translation along a line that takes (u, t) to (0, 0, 1): with I + uuᵀ/(1 + t), −u and t. Its inverse takes
/// (−u, t) there.
BallMatrix to_centre(const BallVector& p) {
  const Ball& t = p[2];
  BallMatrix m;
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t k = 0; k < 2; ++k) m[i][k] = p[i] * p[k] / (t + 1);
    m[i][i] = m[i][i] + 1;
    m[i][2] = m[2][i] = -p[i];
  }
  m[2][2] = t;
  return m;
}

}  // namespace

Frame::Frame(const BallVector& origin, slong precision) : precision_(precision) {
  const Precision scope(precision);
  to_frame_ = to_centre(origin);
  from_frame_ = to_centre({-origin[0], -origin[1], origin[2]});
}

Interval Frame::cosh_distance(const BallVector& p) const {
  Ball result;
  certify::dot(result, to_frame_[2], p, precision_);
  return fast_interval(result);
}

Frame::Point Frame::point(const BallVector& p) const { return in_binary64(apply(to_frame_, p, precision_)); }

Interval Frame::displacement(std::uint32_t k, const Element& element, const Point& p) {
  const auto [found, is_new] = elements_.try_emplace(k);
  if (is_new) {
    // A row r is r times the inverse in the coordinates of the frame; the matrix is symmetric.
    found->second = {in_binary64(apply(from_frame_, element.normal_row, precision_)), fast_interval(element.square)};
  }
  return found->second.square + sqr(dot(found->second.row, p));
}

Frame& Frames::near(const BallVector& p) {
  constexpr double kFar = 1.5;  // cosh of the distance.
  const auto is_near = [&](const Frame& frame) { return frame.cosh_distance(p).upper < kFar; };
  if (last_ < frames_.size() && is_near(frames_[last_])) return frames_[last_];
  for (last_ = 0; last_ < frames_.size(); ++last_) {
    if (is_near(frames_[last_])) return frames_[last_];
  }
  return frames_.emplace_back(p, precision_);
}

}  // namespace epsnet::certify
