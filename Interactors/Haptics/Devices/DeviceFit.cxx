// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Devices/DeviceFit.h"

#include "Contact/ContactBody.h"
#include "Contact/ParallelRanges.h"
#include "Contact/ResponseField.h"
#include "Haptics/Devices/WorkspaceMapping.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <mutex>
#include <sstream>

namespace palpate
{
namespace
{
/// Returns the larger value. NaN counts as infinite.
double larger(double peak, double value) noexcept
{
  return std::isnan(value) ? std::numeric_limits<double>::infinity() : std::max(peak, value);
}
} // namespace

DeviceFit::DeviceFit(const DeviceSpecification& device, double scale) noexcept
  : MaximumForce(device.maximumForce)
  , MaximumStiffness(device.maximumStiffness / (MillimetresPerMetre * scale))
{
}

void DeviceFit::include(double force, double stiffness) noexcept
{
  this->PeakForce = larger(this->PeakForce, force);
  this->PeakStiffness = larger(this->PeakStiffness, stiffness);
}

void DeviceFit::include(const ResponseField& response, double depth)
{
  const int halves = 2 * response.sampling().samples();
  std::mutex mutex;
  forRanges(response.pointCount(),
    [&](std::size_t first, std::size_t last)
    {
      double force = 0.0;
      double stiffness = 0.0;
      const auto visit = [&](std::int32_t point, double deflection)
      {
        const ResponseValue value = response.evaluate(point, deflection);
        force = larger(force, value.force);
        stiffness = larger(stiffness, value.stiffness);
      };
      for (std::size_t i = first; i < last; ++i)
      {
        const auto point = static_cast<std::int32_t>(i);
        if (!response.isValid(point))
        {
          continue;
        }
        const double range = response.range(point);
        for (int j = 2; j <= halves; ++j)
        {
          const double root = static_cast<double>(j) / halves;
          const double deflection = range * (root * root);
          if (deflection >= depth)
          {
            break;
          }
          visit(point, deflection);
        }
        visit(point, std::max(depth, response.sampling().depth(0, range)));
      }
      const std::lock_guard<std::mutex> lock(mutex);
      this->include(force, stiffness);
    });
}

void DeviceFit::include(const ContactBody& body, double depth)
{
  if (!body.relaxation)
  {
    this->include(body.response, depth);
    return;
  }
  DeviceFit slow(*this);
  slow.PeakForce = 0.0;
  slow.PeakStiffness = 0.0;
  slow.include(body.response, depth);
  const double instantaneous = 1.0 + body.relaxation->strongest();
  this->include(instantaneous * slow.PeakForce, instantaneous * slow.PeakStiffness);
}

double DeviceFit::factor() const noexcept
{
  const auto share = [](double most, double peak)
  { return peak > 0.0 ? std::max(0.0, most / peak) : 1.0; };
  const double factor = std::min({ 1.0, share(this->MaximumForce, this->PeakForce),
    share(this->MaximumStiffness, this->PeakStiffness) });
  return std::isnan(factor) ? 0.0 : factor;
}

std::string DeviceFit::reason() const
{
  if (!(this->factor() < 1.0))
  {
    return {};
  }
  const bool isWeak =
    this->MaximumForce * this->PeakStiffness <= this->MaximumStiffness * this->PeakForce;
  const char* const unit = isWeak ? " N" : " N/mm";
  std::ostringstream text;
  text << std::setprecision(3) << "the device is too " << (isWeak ? "weak: " : "soft: ")
       << (isWeak ? this->MaximumForce : this->MaximumStiffness) << unit << " of "
       << (isWeak ? this->PeakForce : this->PeakStiffness) << unit;
  return text.str();
}
} // namespace palpate
