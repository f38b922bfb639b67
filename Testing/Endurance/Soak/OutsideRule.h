// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_endurance_OutsideRule_h
#define palpate_endurance_OutsideRule_h

namespace palpate::endurance
{
/// Whether the tip has been outside since the last loss. At a depth near zero the checker cannot
/// decide whether the tip is inside or outside, so the tip may have been outside. The sent force
/// then shows which decision the loop has made.
class OutsideRule
{
public:
  void lose() { *this = {}; }
  void see(bool isInside, bool isOutside)
  {
    this->MayPass = this->MayPass || !isInside;
    this->MustPass = this->MustPass || isOutside;
  }
  void settle(bool passes)
  {
    this->MayPass = passes;
    this->MustPass = passes;
  }
  bool mayPass() const { return this->MayPass; }
  bool mustPass() const { return this->MustPass; }

private:
  bool MayPass = false;
  bool MustPass = false;
};
} // namespace palpate::endurance

#endif
