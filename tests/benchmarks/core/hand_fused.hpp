#pragma once

#include <array>
#include <cmath>
#include <experimental/simd>

namespace rfm::benchmarks {

/// What the tape is measured against: the R₀-conjunction of six primitives in space with value,
/// gradient and Hessian, written by hand as one template, everything inlined. `fused_conjunction`
/// is the rule of rank one; `naive_conjunction` composes overloaded + − · √, as dual numbers do.
/// Members have names of their own: GCC keeps those in registers, but not arrays.
template <class T>
struct HandJet {
  T v, x, y, z, xx, xy, xz, yy, yz, zz;
};

/// A plane d − n·x, or the outside of a sphere of radius d about n.
struct HandPrimitive {
  bool sphere;
  std::array<double, 3> n;
  double d;
};

inline constexpr std::array<HandPrimitive, 6> hand_primitives{{{false, {1, 0, 0}, 1.1},
                                                               {false, {0, 1, 0}, 1.2},
                                                               {false, {0, 0.6, 0.8}, 1.15},
                                                               {false, {-0.6, 0, 0.8}, 1.3},
                                                               {true, {2, 2, 2}, 0.7},
                                                               {true, {-1.5, 1.6, -1.4}, 0.5}}};
/// Operations of the fused form at one point: four planes of 6, two spheres of 11, five
/// conjunctions of 67. The same count serves every variant, so that rates compare useful work.
inline constexpr double hand_operations = 4 * 6 + 2 * 11 + 5 * 67;

template <class T>
HandJet<T> primitive(const HandPrimitive& p, const T& x, const T& y, const T& z) {
  const T zero = x * 0.0;
  const double n0 = p.n[0], n1 = p.n[1], n2 = p.n[2];
  if (!p.sphere)
    return {p.d - n0 * x - n1 * y - n2 * z,
            zero - n0,
            zero - n1,
            zero - n2,
            zero,
            zero,
            zero,
            zero,
            zero,
            zero};
  const double inverse = 1 / p.d;
  const T a = x - n0, b = y - n1, c = z - n2, one = zero + inverse;
  return {0.5 * inverse * (a * a + b * b + c * c) - 0.5 * p.d,
          inverse * a,
          inverse * b,
          inverse * c,
          one,
          zero,
          zero,
          one,
          zero,
          one};
}

template <class T>
HandJet<T> fused_conjunction(const HandJet<T>& a, const HandJet<T>& b) {
  using std::sqrt;
  const T root = sqrt(a.v * a.v + b.v * b.v), inverse = 1.0 / root;
  const T p = 1.0 - a.v * inverse, q = 1.0 - b.v * inverse, cube = inverse * inverse * inverse;
  const T wx = b.v * a.x - a.v * b.x, wy = b.v * a.y - a.v * b.y, wz = b.v * a.z - a.v * b.z;
  const T cx = cube * wx, cy = cube * wy, cz = cube * wz;
  return {a.v + b.v - root,
          p * a.x + q * b.x,
          p * a.y + q * b.y,
          p * a.z + q * b.z,
          p * a.xx + q * b.xx - cx * wx,
          p * a.xy + q * b.xy - cx * wy,
          p * a.xz + q * b.xz - cx * wz,
          p * a.yy + q * b.yy - cy * wy,
          p * a.yz + q * b.yz - cy * wz,
          p * a.zz + q * b.zz - cz * wz};
}

template <class T>
HandJet<T> operator+(const HandJet<T>& a, const HandJet<T>& b) {
  return {a.v + b.v,   a.x + b.x,   a.y + b.y,   a.z + b.z,   a.xx + b.xx,
          a.xy + b.xy, a.xz + b.xz, a.yy + b.yy, a.yz + b.yz, a.zz + b.zz};
}

template <class T>
HandJet<T> operator-(const HandJet<T>& a, const HandJet<T>& b) {
  return {a.v - b.v,   a.x - b.x,   a.y - b.y,   a.z - b.z,   a.xx - b.xx,
          a.xy - b.xy, a.xz - b.xz, a.yy - b.yy, a.yz - b.yz, a.zz - b.zz};
}

template <class T>
HandJet<T> operator*(const HandJet<T>& a, const HandJet<T>& b) {
  return {a.v * b.v,
          a.v * b.x + b.v * a.x,
          a.v * b.y + b.v * a.y,
          a.v * b.z + b.v * a.z,
          a.v * b.xx + b.v * a.xx + 2.0 * a.x * b.x,
          a.v * b.xy + b.v * a.xy + a.x * b.y + a.y * b.x,
          a.v * b.xz + b.v * a.xz + a.x * b.z + a.z * b.x,
          a.v * b.yy + b.v * a.yy + 2.0 * a.y * b.y,
          a.v * b.yz + b.v * a.yz + a.y * b.z + a.z * b.y,
          a.v * b.zz + b.v * a.zz + 2.0 * a.z * b.z};
}

template <class T>
HandJet<T> square_root(const HandJet<T>& a) {
  using std::sqrt;
  const T value = sqrt(a.v), first = 0.5 / value, second = -first / (2.0 * a.v);
  return {value,
          first * a.x,
          first * a.y,
          first * a.z,
          first * a.xx + second * a.x * a.x,
          first * a.xy + second * a.x * a.y,
          first * a.xz + second * a.x * a.z,
          first * a.yy + second * a.y * a.y,
          first * a.yz + second * a.y * a.z,
          first * a.zz + second * a.z * a.z};
}

template <class T>
HandJet<T> naive_conjunction(const HandJet<T>& a, const HandJet<T>& b) {
  return a + b - square_root(a * a + b * b);
}

}  // namespace rfm::benchmarks
