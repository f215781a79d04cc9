#pragma once

namespace arelem::geometry {

/// A value of two parameters s and t with its derivatives up to the second, over numbers or over
/// intervals: then each member holds all values over a box of s and t.
template <class T>
struct Jet {
  T value{}, s{}, t{}, ss{}, st{}, tt{};

  Jet() = default;
  Jet(const T& constant) : value(constant) {}  // NOLINT: constants are jets
};

template <class T>
Jet<T> operator+(const Jet<T>& a, const Jet<T>& b) {
  Jet<T> c;
  c.value = a.value + b.value;
  c.s = a.s + b.s;
  c.t = a.t + b.t;
  c.ss = a.ss + b.ss;
  c.st = a.st + b.st;
  c.tt = a.tt + b.tt;
  return c;
}
template <class T>
Jet<T> operator*(const Jet<T>& a, const Jet<T>& b) {
  const T two(2.0);
  Jet<T> c;
  c.value = a.value * b.value;
  c.s = a.s * b.value + a.value * b.s;
  c.t = a.t * b.value + a.value * b.t;
  c.ss = a.ss * b.value + two * (a.s * b.s) + a.value * b.ss;
  c.st = a.st * b.value + a.s * b.t + a.t * b.s + a.value * b.st;
  c.tt = a.tt * b.value + two * (a.t * b.t) + a.value * b.tt;
  return c;
}
template <class T>
Jet<T> operator-(const Jet<T>& a, const Jet<T>& b) {
  return a + Jet<T>(T(-1.0)) * b;
}
/// By q b = a, derived twice. b must not be 0.
template <class T>
Jet<T> operator/(const Jet<T>& a, const Jet<T>& b) {
  const T two(2.0);
  Jet<T> q;
  q.value = a.value / b.value;
  q.s = (a.s - q.value * b.s) / b.value;
  q.t = (a.t - q.value * b.t) / b.value;
  q.ss = (a.ss - two * (q.s * b.s) - q.value * b.ss) / b.value;
  q.st = (a.st - q.s * b.t - q.t * b.s - q.value * b.st) / b.value;
  q.tt = (a.tt - two * (q.t * b.t) - q.value * b.tt) / b.value;
  return q;
}

}  // namespace arelem::geometry
