// SPDX-License-Identifier: BSD-3-Clause
#include "RelaxationMethods.h"

#include "RelaxationFoundation.h"
#include "RelaxationPaths.h"
#include "RelaxingPlate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace palpate::testing
{
namespace
{
constexpr std::size_t ManyElements = 256;

std::shared_ptr<const ContactBody> plateOf(double exponent, const PronySeries& series)
{
  return RelaxingPlate(exponent, series).body();
}

ContactSettings settingsOf(int elements)
{
  ContactSettings settings;
  settings.relaxationElements = elements;
  return settings;
}

/// The complete tick of Palpate.
class TickMethod final : public ContactMethod
{
public:
  TickMethod(std::string name, std::shared_ptr<const ContactBody> body, int elements)
    : Name(std::move(name))
    , Body(std::move(body))
    , Contact(*this->Body, settingsOf(elements))
  {
  }
  std::string name() const override { return this->Name; }
  Vector3 force(const Vector3& tip) override
  {
    return this->Contact.update(tip, RelaxationPeriod).force;
  }
  void forget() override { this->Contact.reset(); }
  std::size_t bytes() const override { return sizeof(ToolContact); }

private:
  std::string Name;
  std::shared_ptr<const ContactBody> Body;
  ToolContact Contact;
};

/// The usual method: the branches follow the force of the curve, and a negative total force is
/// replaced by 0. The memory still contains the negative part, so that the next press is wrong.
class ClampedMethod final : public ContactMethod
{
public:
  ClampedMethod(std::shared_ptr<const ContactBody> body, const PronySeries& series)
    : Body(std::move(body))
    , Contact(*this->Body)
    , Series(series)
  {
    for (std::size_t i = 0; i < series.count; ++i)
    {
      const double x = RelaxationPeriod / series.time[i];
      this->Decay[i] = std::exp(-x);
      this->Gain[i] = -series.strength[i] * std::expm1(-x) / x;
    }
  }
  std::string name() const override { return "quasi-linear, clamped"; }
  Vector3 force(const Vector3& tip) override
  {
    const palpate::Contact felt = this->Contact.update(tip);
    double force = felt.normalForce;
    for (std::size_t i = 0; i < this->Series.count; ++i)
    {
      this->Over[i] =
        this->Decay[i] * this->Over[i] + this->Gain[i] * (felt.normalForce - this->Slow);
      force += this->Over[i];
    }
    this->Slow = felt.normalForce;
    return { 0.0, 0.0, felt.normalForce > 0.0 ? std::max(force, 0.0) : 0.0 };
  }
  void forget() override
  {
    this->Contact.reset();
    this->Over.fill(0.0);
    this->Slow = 0.0;
  }
  std::size_t bytes() const override { return sizeof(*this); }

private:
  using Branches = std::array<double, PronySeries::LargestCount>;

  std::shared_ptr<const ContactBody> Body;
  ToolContact Contact;
  PronySeries Series;
  Branches Decay{};
  Branches Gain{};
  Branches Over{};
  double Slow = 0.0;
};

/// The exact law with many elements, evaluated in the tick.
class ManyMethod final : public ContactMethod
{
public:
  ManyMethod(std::shared_ptr<const ContactBody> body, double exponent, const PronySeries& series)
    : Body(std::move(body))
    , Contact(*this->Body)
    , Foundation(exponent, series, ManyElements)
  {
  }
  std::string name() const override { return "exact: 256 elements"; }
  Vector3 force(const Vector3& tip) override
  {
    const palpate::Contact felt = this->Contact.update(tip);
    const double depth = felt.normalForce > 0.0 ? felt.deflection : -1.0;
    return { 0.0, 0.0, this->Foundation.press(depth, RelaxationPeriod) };
  }
  void forget() override
  {
    this->Contact.reset();
    this->Foundation.forget();
  }
  std::size_t bytes() const override { return sizeof(*this) + this->Foundation.bytes(); }

private:
  std::shared_ptr<const ContactBody> Body;
  ToolContact Contact;
  RelaxationFoundation Foundation;
};
} // namespace

std::vector<std::unique_ptr<ContactMethod>> relaxationMethods(
  double exponent, const PronySeries& series)
{
  const std::shared_ptr<const ContactBody> elastic = plateOf(exponent, {});
  const std::shared_ptr<const ContactBody> relaxing = plateOf(exponent, series);
  std::vector<std::unique_ptr<ContactMethod>> methods;
  methods.push_back(std::make_unique<TickMethod>("time left out", elastic, 16));
  methods.push_back(std::make_unique<ClampedMethod>(elastic, series));
  methods.push_back(std::make_unique<TickMethod>("quasi-linear, one-sided", relaxing, 0));
  for (const int count : { 4, 8, 16, 32 })
  {
    methods.push_back(
      std::make_unique<TickMethod>(std::to_string(count) + " elements", relaxing, count));
  }
  methods.push_back(std::make_unique<ManyMethod>(elastic, exponent, series));
  return methods;
}

Vector3 relaxationTip(double depth)
{
  return tipAt(depth);
}
} // namespace palpate::testing
