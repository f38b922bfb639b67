// SPDX-License-Identifier: BSD-3-Clause
// specificationOf: uses only the credible values of a description.
#include "Transports/Hid/HapticReport.h"

#include <cmath>
#include <sstream>

namespace palpate
{
namespace
{
/// Replaces the conservative `value` by the `stated` one if `stated` is above 0 and within the
/// limits `least` and `most`.
class CredibleValues
{
public:
  explicit CredibleValues(std::string* replaced)
    : Replaced(replaced)
  {
  }

  void take(
    const char* name, const char* unit, double stated, double least, double most, double& value)
  {
    if (stated >= least && stated <= most && stated > 0.0) // the condition is false for NaN
    {
      value = stated;
    }
    else if (this->Replaced != nullptr)
    {
      std::ostringstream words;
      words << (this->Replaced->empty() ? "" : "; ") << name << ' ' << stated << ' ' << unit
            << " is not credible, " << value << ' ' << unit << " is assumed";
      *this->Replaced += words.str();
    }
  }

private:
  std::string* Replaced;
};
} // namespace

DeviceSpecification carefulSpecification() noexcept
{
  DeviceSpecification careful;
  careful.maximumForce = 2.0;
  careful.maximumStiffness = 500.0;
  careful.maximumForceRate = 200.0;
  careful.maximumDamping = 1.0;
  careful.workspace.setConstant(0.05);
  careful.rate = 1000.0;
  careful.sampleTimeOut = 0.02;
  careful.maximumTorsionalStiffness = 0.02;
  careful.maximumTorqueRate = 2.0;
  return careful;
}

DeviceSpecification specificationOf(const DescriptionReport& description, std::string* replaced)
{
  DeviceSpecification specification = carefulSpecification();
  specification.outputsForce = description.outputsForce;
  CredibleValues values(replaced);
  if (description.outputsForce)
  {
    values.take(
      "maximum force", "N", description.maximumForce, 0.0, 100.0, specification.maximumForce);
    values.take("maximum stiffness", "N/m", description.maximumStiffness, 0.0, 20000.0,
      specification.maximumStiffness);
    values.take("maximum force rate", "N/s", description.maximumForceRate, 0.0,
      std::numeric_limits<double>::infinity(), specification.maximumForceRate);
    values.take("maximum damping", "N s/m", description.maximumDamping, 0.0, 200.0,
      specification.maximumDamping);
  }
  else
  {
    specification.maximumForce = 0.0;
  }
  specification.outputsTorque = description.outputsTorque;
  if (description.outputsTorque)
  {
    specification.maximumTorque = 0.02;
    values.take(
      "maximum torque", "N m", description.maximumTorque, 0.0, 5.0, specification.maximumTorque);
    values.take("maximum torsional stiffness", "N m/rad", description.maximumTorsionalStiffness,
      0.0, 100.0, specification.maximumTorsionalStiffness);
    values.take("maximum torque rate", "N m/s", description.maximumTorqueRate, 0.0,
      std::numeric_limits<double>::infinity(), specification.maximumTorqueRate);
  }
  const char* const extents[] = { "half extent in x", "half extent in y", "half extent in z" };
  for (int axis = 0; axis < 3; ++axis)
  {
    const bool flat = description.planar && axis == 2;
    if (flat && description.workspace[axis] == 0.0)
    {
      specification.workspace[axis] = 0.0;
      continue;
    }
    values.take(
      extents[axis], "m", description.workspace[axis], 0.0, 2.0, specification.workspace[axis]);
  }
  values.take("rate", "Hz", description.rate, 10.0, 20000.0, specification.rate);
  values.take(
    "sample time-out", "s", description.sampleTimeOut, 0.0, 0.1, specification.sampleTimeOut);
  return specification;
}
} // namespace palpate
