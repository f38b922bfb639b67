// SPDX-License-Identifier: BSD-3-Clause
#include "ForceTrust.h"

#include "Contact/ResponseContract.h"
#include "Haptics/Servo/ServoStep.h"
#include "Mechanics/JoinedText.h"
#include "Response/Curves/StoredError.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace palpate
{
namespace
{
// Largest relative error. A larger error (above 100 %) gives no information.
constexpr double Unbounded = 1.0;

struct Trust
{
  /// Relative errors of the ticks in contact, ascending; empty if no errors are stored.
  std::vector<double> errors;
  double valid = 0.0;          ///< fraction of the ticks within the validity at all three corners
  const Tick* worst = nullptr; ///< tick with the largest error
  std::string limit;           ///< reason why the validity ends, in the tick with the largest error
  bool touches = false;
};

Trust judge(vtkPolyData* body, const std::vector<Tick>& ticks)
{
  vtkDataArray* validity = body->GetPointData()->GetArray("ResponseValidity");
  vtkDataArray* limit = body->GetPointData()->GetArray("ResponseLimit");
  const StoredError stored(body, "Response");
  const vtkIdType firstPoly = body->GetNumberOfVerts() + body->GetNumberOfLines();
  double largest = -1.0;
  double touching = 0.0;
  double valid = 0.0;
  Trust trust;
  for (const Tick& tick : ticks)
  {
    if (tick.contact.triangle < 0)
    {
      continue;
    }
    touching += 1.0;
    vtkIdType count = 0;
    const vtkIdType* corners = nullptr;
    body->GetCellPoints(firstPoly + tick.contact.triangle, count, corners);
    const vtkIdType weakest = *std::min_element(corners, corners + count,
      [&](vtkIdType a, vtkIdType b) { return validity->GetTuple1(a) < validity->GetTuple1(b); });
    const bool isValid = tick.contact.deflection <= validity->GetTuple1(weakest);
    valid += isValid ? 1.0 : 0.0;
    double error = isValid ? 0.0 : Unbounded;
    if (stored.isKept())
    {
      const double found = stored.at(firstPoly + tick.contact.triangle,
        tick.contact.contactPoint.data(), tick.contact.deflection);
      error = found < Unbounded
        ? found
        : Unbounded; // this is also the case beyond the range, where `found` is NaN
      trust.errors.push_back(error);
    }
    if (error > largest)
    {
      largest = error;
      trust.worst = &tick;
      trust.limit = limitInWords(static_cast<int>(limit->GetTuple1(weakest)));
    }
  }
  std::sort(trust.errors.begin(), trust.errors.end());
  trust.touches = touching > 0.0;
  trust.valid = trust.touches ? valid / touching : 0.0;
  return trust;
}

std::string percent(double share)
{
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3g %%", 100.0 * share);
  return text.data();
}

/// Returns the fraction of the errors that are at least `bound`. `errors` must be in ascending
/// order.
double shareFrom(const std::vector<double>& errors, double bound)
{
  const auto first = std::lower_bound(errors.begin(), errors.end(), bound);
  return static_cast<double>(errors.end() - first) / static_cast<double>(errors.size());
}

/// Returns errorInWords() without the space before the sign.
std::string signedPercent(double error)
{
  return errorInWords(error).substr(1);
}
} // namespace

std::string describeTrust(vtkPolyData* body, const std::vector<Tick>& ticks, double tolerance,
  const std::function<std::string(const Tick&)>& causeOf)
{
  const Trust trust = judge(body, ticks);
  if (!trust.touches)
  {
    return {};
  }
  const bool hasErrors = !trust.errors.empty();
  const std::string reason = hasErrors ? causeOf(*trust.worst) : trust.limit;
  const std::string cause = reason.empty() ? "" : ", mainly due to " + reason;
  if (!hasErrors)
  {
    return joined("not stored; the law is valid in ", percent(trust.valid), " of the contact",
      trust.valid < 1.0 ? cause : std::string());
  }
  const double median = trust.errors[trust.errors.size() / 2];
  const double without = shareFrom(trust.errors, Unbounded);
  const std::string largest = without > 0.0
    ? "without a bound in " + percent(without) + " of the contact"
    : signedPercent(trust.errors.back());
  const std::string usual = median < Unbounded ? signedPercent(median) : largest;
  std::string text = usual;
  if (usual != largest)
  {
    text += " typically, " + largest + (without > 0.0 ? "" : " at most");
  }
  text += cause;
  const double above =
    tolerance > 0.0 ? shareFrom(trust.errors, std::nextafter(tolerance, Unbounded)) : 0.0;
  return above > without
    ? text + "; above " + signedPercent(tolerance) + " in " + percent(above) + " of the contact"
    : text;
}
} // namespace palpate
