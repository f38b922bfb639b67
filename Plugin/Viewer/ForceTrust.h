// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ForceTrust_h
#define palpate_ForceTrust_h

#include <functional>
#include <string>
#include <vector>

class vtkPolyData;

namespace palpate
{
struct Tick;

/**
 * Describes the error of the forces of a session in one sentence, e.g. "± 2 % typically, ± 7 % at
 * most, mainly due to strain; above ± 5 % in 12 % of the contact", or "± 2 %, mainly due to
 * strain". The body has the response "Response". The fraction of the contact with a relative error
 * above `tolerance` is stated unless `tolerance` is 0. `causeOf` returns the cause of the error of
 * a tick; it is called for the tick with the largest error. Without a stored error, the sentence
 * states the fraction of the contact that is within the validity of the law. Returns "" without
 * contact.
 */
std::string describeTrust(vtkPolyData* body, const std::vector<Tick>& ticks, double tolerance,
  const std::function<std::string(const Tick&)>& causeOf);
} // namespace palpate

#endif
