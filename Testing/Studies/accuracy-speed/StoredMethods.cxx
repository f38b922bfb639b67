// SPDX-License-Identifier: BSD-3-Clause
#include "StoredMethods.h"

#include "Contact/ResponseSampling.h"
#include "Contact/ToolContact.h"
#include "TrackedMethod.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace palpate::testing
{
namespace
{
class KernelMethod final : public ContactMethod
{
public:
  KernelMethod(std::string name, std::unique_ptr<ContactBody> body, const ContactSettings& settings)
    : Name(std::move(name))
    , Body(std::move(body))
    , Contact(*this->Body, settings)
  {
  }
  std::string name() const override { return this->Name; }
  Vector3 force(const Vector3& tip) override { return this->Contact.update(tip).force; }
  void forget() override { this->Contact.reset(); }
  std::size_t bytes() const override
  {
    return this->Body->surface.memory() + this->Body->tree.memory() + this->Body->response.memory();
  }

private:
  std::string Name;
  std::unique_ptr<ContactBody> Body;
  ToolContact Contact;
};

/// Records of `width` numbers per point, in packed order.
template <class Number>
class SampleRecords
{
public:
  SampleRecords(const StudyBody& body, std::size_t width)
    : Width(width)
    , Numbers(width * body.pointCount())
  {
  }
  Number& at(std::size_t point, std::size_t i) { return this->Numbers[this->Width * point + i]; }
  double blend(const TouchedPlace& place, std::size_t i) const
  {
    double sum = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::size_t record = this->Width * static_cast<std::size_t>(place.corners[k]);
      sum += place.weights[static_cast<Eigen::Index>(k)] *
        static_cast<double>(this->Numbers[record + i]);
    }
    return sum;
  }
  std::size_t bytes() const { return sizeof(Number) * this->Numbers.size(); }

private:
  std::size_t Width;
  std::vector<Number> Numbers;
};

class Linear final : public TrackedMethod
{
public:
  Linear(const std::string& name, const StudyBody& body, const SampledCurves& curves)
    : TrackedMethod(name, body)
    , Samples(static_cast<std::size_t>(curves.samples))
    , Range(curves.range)
    , Records(body, this->Samples)
  {
    for (std::size_t p = 0; p < body.pointCount(); ++p)
    {
      const auto input =
        static_cast<std::size_t>(body.packed().inputPoint(static_cast<std::int32_t>(p)));
      for (std::size_t i = 0; i < this->Samples; ++i)
      {
        this->Records.at(p, i) = static_cast<float>(curves.force[input * this->Samples + i]);
      }
    }
  }

protected:
  double magnitude(const TouchedPlace& place) override
  {
    const auto n = static_cast<double>(this->Samples);
    const double position = n * std::sqrt(place.depth / this->Range);
    const std::size_t below = std::min(static_cast<std::size_t>(position), this->Samples - 1);
    const auto depthAt = [&](std::size_t i)
    {
      const double root = static_cast<double>(i) / n;
      return this->Range * root * root;
    };
    const double low = below == 0 ? 0.0 : this->Records.blend(place, below - 1);
    const double high = this->Records.blend(place, below);
    const double share = (place.depth - depthAt(below)) / (depthAt(below + 1) - depthAt(below));
    return low + share * (high - low);
  }
  std::size_t modelBytes() const override { return this->Records.bytes(); }

private:
  std::size_t Samples;
  double Range;
  SampleRecords<float> Records; ///< forces
};

template <class Number>
class HermiteIn final : public TrackedMethod
{
public:
  HermiteIn(const std::string& name, const StudyBody& body, const SampledCurves& curves)
    : TrackedMethod(name, body)
    , Sampling(curves.samples, curves.exponent)
    , Range(curves.range)
    , Records(body, 2 * static_cast<std::size_t>(curves.samples))
  {
    const auto n = static_cast<std::size_t>(curves.samples);
    for (std::size_t p = 0; p < body.pointCount(); ++p)
    {
      const auto input =
        static_cast<std::size_t>(body.packed().inputPoint(static_cast<std::int32_t>(p)));
      for (std::size_t i = 0; i < n; ++i)
      {
        this->Records.at(p, 2 * i) = static_cast<Number>(curves.force[input * n + i]);
        this->Records.at(p, 2 * i + 1) = static_cast<Number>(curves.stiffness[input * n + i]);
      }
    }
  }

protected:
  double magnitude(const TouchedPlace& place) override
  {
    const Blended curve{ this->Records, place };
    return this->Sampling.evaluate(curve, this->Range, place.depth).force;
  }
  std::size_t modelBytes() const override { return this->Records.bytes(); }

private:
  struct Blended
  {
    const SampleRecords<Number>& records;
    const TouchedPlace& place;
    double force(int i) const { return records.blend(place, 2 * static_cast<std::size_t>(i)); }
    double stiffness(int i) const
    {
      return records.blend(place, 2 * static_cast<std::size_t>(i) + 1);
    }
  };

  ResponseSampling Sampling;
  double Range;
  SampleRecords<Number> Records; ///< force and stiffness per sample
};
} // namespace

std::unique_ptr<ContactMethod> hermite(const std::string& name, const StudyBody& body,
  const SampledCurves& curves, ContactSurface surface)
{
  ContactSettings settings;
  settings.surface = surface;
  return std::make_unique<KernelMethod>(name, body.respond(curves), settings);
}

std::unique_ptr<ContactMethod> reducedBasis(
  const std::string& name, const StudyBody& body, const SampledCurves& curves, double tolerance)
{
  return std::make_unique<KernelMethod>(
    name, body.respondReduced(curves, tolerance), ContactSettings{});
}

std::unique_ptr<ContactMethod> linear(
  const std::string& name, const StudyBody& body, const SampledCurves& curves)
{
  return std::make_unique<Linear>(name, body, curves);
}

std::unique_ptr<ContactMethod> hermiteIn(
  FloatWidth width, const std::string& name, const StudyBody& body, const SampledCurves& curves)
{
  switch (width)
  {
    case FloatWidth::Half:
      return std::make_unique<HermiteIn<Eigen::half>>(name, body, curves);
    case FloatWidth::Single:
      return std::make_unique<HermiteIn<float>>(name, body, curves);
    default:
      return std::make_unique<HermiteIn<double>>(name, body, curves);
  }
}
} // namespace palpate::testing
