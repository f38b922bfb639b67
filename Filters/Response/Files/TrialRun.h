// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TrialRun_h
#define palpate_TrialRun_h

#include <functional>
#include <string>

namespace palpate
{
/// Runs `work` in a copy of this process, and says how the copy crashed, as "Segmentation fault",
/// or
/// "" if it did not: the same work then does not crash here. VTK's readers of files are tried so,
/// since damaged files crash them. To want more than `memory` bytes is a crash, too. Nothing is
/// printed, and loops are sequential there. Costs the time of the work and of the copy, some
/// milliseconds. Call it while no other thread uses VTK.
std::string crashOf(const std::function<void()>& work, double memory);
} // namespace palpate

#endif
