// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_ClosedRelaxation_h
#define palpate_testing_ClosedRelaxation_h

#include "Identification/MeasuredCurve.h"
#include "Mechanics/Relaxation/PronySeries.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace palpate::testing
{
/// M(1; m+1; -x) = m ∫₀¹ e^(-x(1-v)) v^(m-1) dv, by Simpson's rule over w = √v (m >= 1/2).
inline double kummerByQuadrature(double m, double x)
{
  constexpr int steps = 400;
  const auto f = [&](double w)
  { return 2.0 * m * std::exp(-x * (1.0 - w * w)) * std::pow(w, 2.0 * m - 1.0); };
  double sum = f(0.0) + f(1.0);
  for (int i = 1; i < steps; ++i)
  {
    sum += (i % 2 ? 4.0 : 2.0) * f(static_cast<double>(i) / steps);
  }
  return sum / (3.0 * steps);
}

/// A press at constant speed to `depth` in `ramp` seconds and a hold, for a slow curve c δ^m (Lee
/// and Radok 1960).
struct RampAndHold
{
  PronySeries series;
  double m = 1.5;
  double c = 1.0; ///< N/mm^m
  double depth = 1.0;
  double ramp = 0.05;

  double deflectionAt(double t) const { return this->depth * std::min(t / this->ramp, 1.0); }
  double forceAt(double t) const
  {
    const double pressed = std::min(t, this->ramp);
    double factor = 1.0;
    for (std::size_t i = 0; i < this->series.count; ++i)
    {
      const double tau = this->series.time[i];
      factor += this->series.strength[i] * std::exp(-(t - pressed) / tau) *
        kummerByQuadrature(this->m, pressed / tau);
    }
    return this->c * std::pow(this->deflectionAt(t), this->m) * factor;
  }
};

/// Pressed and released at one speed, `up` seconds each way, with one branch of relaxation (Ting
/// 1966): t1 from Lambert's function, then the formula of the ramp.
struct Triangle
{
  double p = 1.0;
  double tau = 1.0;
  double m = 1.5;
  double c = 1.0;
  double depth = 1.0;
  double up = 1.0;

  double deflectionAt(double t) const
  {
    return this->depth * (t < this->up ? t / this->up : 2.0 - t / this->up);
  }
  double forceAt(double t) const
  {
    double t1 = t;
    if (t > this->up)
    {
      const double b = 2.0 * this->up - t +
        this->p * this->tau * (2.0 * std::exp(-(t - this->up) / this->tau) - 1.0);
      // w = W(z) satisfies w + ln w = ln z, which is solved by Newton's method.
      const double logZ = std::log(this->p) + (b - t) / this->tau;
      double w = logZ > 1.0 ? logZ - std::log(logZ) : std::exp(logZ);
      for (int i = 0; i < 30; ++i)
      {
        w *= (1.0 + logZ - std::log(w)) / (1.0 + w);
      }
      t1 = b - this->tau * w;
    }
    if (!(t1 > 0.0))
    {
      return 0.0;
    }
    return this->c * std::pow(this->depth * t1 / this->up, this->m) *
      (1.0 +
        this->p * std::exp(-(t - t1) / this->tau) * kummerByQuadrature(this->m, t1 / this->tau));
  }
};

/// ∫ψ(t-s) df(δ(s)) for a press at constant speed and a hold, for any slow curve f. By the midpoint
/// rule over steps of the press.
template <class Law>
double rampAndHold(const Law& law, const PronySeries& series, double depth, double ramp, double t)
{
  constexpr int steps = 500;
  const double pressed = std::min(t, ramp);
  double sum = 0.0;
  double before = 0.0;
  for (int i = 1; i <= steps; ++i)
  {
    const double s = pressed * i / steps;
    const double now = law(depth * s / ramp);
    sum += (now - before) * relaxationAt(series, t - s + 0.5 * pressed / steps);
    before = now;
  }
  return sum;
}

/// Times of readings, evenly spaced over a duration in seconds.
inline std::vector<double> evenTimes(double seconds, int count)
{
  std::vector<double> times;
  for (int i = 1; i <= count; ++i)
  {
    times.push_back(seconds * i / count);
  }
  return times;
}

/// Times of readings: evenly spaced during the press, then with growing intervals.
inline std::vector<double> rampAndHoldTimes(double ramp, double hold, int onRamp, int onHold)
{
  std::vector<double> times = evenTimes(ramp, onRamp);
  const double first = ramp / onRamp;
  for (int i = 0; i < onHold; ++i)
  {
    times.push_back(ramp + first * std::pow(hold / first, static_cast<double>(i) / (onHold - 1)));
  }
  return times;
}

/// A curve as an instrument records it: it reads `offset` mm at first contact. Ten readings before
/// the contact form the approach.
template <class Deflection, class Force>
MeasuredCurve timedCurve(const std::vector<double>& times, const Deflection& deflection,
  const Force& force, double offset, double noise, std::mt19937& random)
{
  std::normal_distribution<double> normal;
  MeasuredCurve curve;
  const double start = times.front();
  for (int i = 10; i >= 0; --i) // the approach
  {
    curve.time.push_back(-start * i);
    curve.deflection.push_back(offset - i * deflection(start));
    curve.force.push_back(noise * normal(random));
  }
  for (const double t : times)
  {
    curve.time.push_back(t);
    curve.deflection.push_back(offset + deflection(t));
    curve.force.push_back(force(t) + noise * normal(random));
  }
  return curve;
}

/// The measured curve of a RampAndHold or a Triangle.
template <class Press>
MeasuredCurve timedCurve(const std::vector<double>& times, const Press& press, double offset,
  double noise, std::mt19937& random)
{
  return timedCurve(
    times, [&press](double t) { return press.deflectionAt(t); },
    [&press](double t) { return press.forceAt(t); }, offset, noise, random);
}
} // namespace palpate::testing

#endif
