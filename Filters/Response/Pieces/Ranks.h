// SPDX-License-Identifier: BSD-3-Clause
#ifndef Ranks_h
#define Ranks_h

#include "palpateResponseModule.h"

#include "vtkSmartPointer.h"

#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

class vtkMultiProcessController;
class vtkPolyData;

namespace palpate
{
/**
 * The processes among which a body is divided. Each process has a piece of the body.
 *
 * All calls except own, count and areAlone are collective: every rank must make them, in the same
 * order. With one rank, or without a controller, these calls return their argument at no cost.
 */
class PALPATERESPONSE_EXPORT Ranks
{
public:
  /// `controller` may be null, which means a single rank. The controller must outlive this object.
  explicit Ranks(vtkMultiProcessController* controller = nullptr);

  bool areAlone() const noexcept { return this->Count == 1; }
  int count() const noexcept { return this->Count; }
  int own() const noexcept { return this->Own; }

  /// Returns whether `own` is true on any rank.
  bool any(bool own) const;
  double largest(double own) const;
  double smallest(double own) const;
  /// Returns the fault of the lowest rank that has a fault, with the number of that rank; "" if no
  /// rank has a fault.
  std::string firstFault(const std::string& own) const;

  /// Returns the values of all ranks, in rank order. The result is the same on all ranks.
  template <class T>
  std::vector<std::vector<T>> gather(const std::vector<T>& own) const
  {
    static_assert(std::is_trivially_copyable<T>::value, "sent byte by byte");
    std::vector<std::vector<T>> all(static_cast<std::size_t>(this->Count));
    if (this->areAlone())
    {
      all[0] = own;
      return all;
    }
    std::vector<std::size_t> ends;
    const std::vector<char> bytes =
      this->gatherBytes(reinterpret_cast<const char*>(own.data()), own.size() * sizeof(T), ends);
    std::size_t begin = 0;
    for (std::size_t rank = 0; rank < ends.size(); ++rank)
    {
      all[rank].resize((ends[rank] - begin) / sizeof(T));
      if (!all[rank].empty())
      {
        std::memcpy(static_cast<void*>(all[rank].data()), bytes.data() + begin, ends[rank] - begin);
      }
      begin = ends[rank];
    }
    return all;
  }

  /// On rank `to`, returns the bodies of all ranks, in rank order. On other ranks, returns an empty
  /// list.
  std::vector<vtkSmartPointer<vtkPolyData>> send(vtkPolyData* own, int to) const;
  /// Copies the body of rank `from` to all ranks.
  void spread(vtkPolyData* body, int from) const;

private:
  std::vector<char> gatherBytes(
    const char* own, std::size_t size, std::vector<std::size_t>& ends) const;

  vtkMultiProcessController* Controller;
  int Count = 1;
  int Own = 0;
};
} // namespace palpate

#endif
