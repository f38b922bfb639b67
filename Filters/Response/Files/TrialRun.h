// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TrialRun_h
#define palpate_TrialRun_h

#include <functional>
#include <string>

namespace palpate
{
/// Runs `work` in a copy of this process. Returns how the copy crashed, such as "Segmentation
/// fault", or "" if it did not; the same work then does not crash in this process. VTK's file
/// readers are tried in this way, since damaged files crash them. A need of more than `memory`
/// bytes counts as a crash, too. The copy prints nothing, and its loops are sequential. Cost: the
/// time of the work, and a few milliseconds for the copy. Call it while no other thread uses VTK.
std::string crashOf(const std::function<void()>& work, double memory);
} // namespace palpate

#endif
