// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TrialRun_h
#define palpate_TrialRun_h

#include <functional>
#include <string>

namespace palpate
{
/// Runs `work` in a copy of this process, because damaged files crash VTK's file readers. Returns
/// the kind of crash, such as "Segmentation fault", or "" if the copy did not crash. In the latter
/// case `work` does not crash in this process either. If `work` needs more than `memory` bytes,
/// this also counts as a crash. The copy prints nothing, and its loops are sequential. The cost is
/// the time of `work` plus a few milliseconds for the copy. Call the function only while no other
/// thread uses VTK.
std::string crashOf(const std::function<void()>& work, double memory);
} // namespace palpate

#endif
