// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Pieces/Ranks.h"

#include "vtkDataObject.h"
#include "vtkMultiProcessController.h"
#include "vtkPolyData.h"

#include <algorithm>

namespace palpate
{
Ranks::Ranks(vtkMultiProcessController* controller)
  : Controller(controller)
{
  if (controller && controller->GetNumberOfProcesses() > 1)
  {
    this->Count = controller->GetNumberOfProcesses();
    this->Own = controller->GetLocalProcessId();
  }
}

bool Ranks::any(bool own) const
{
  return this->largest(own ? 1.0 : 0.0) > 0.0;
}

double Ranks::largest(double own) const
{
  double largest = own;
  for (const std::vector<double>& each : this->gather(std::vector<double>{ own }))
  {
    largest = std::max(largest, each.front());
  }
  return largest;
}

double Ranks::smallest(double own) const
{
  return -this->largest(-own);
}

std::string Ranks::firstFault(const std::string& own) const
{
  if (this->areAlone() || !this->any(!own.empty()))
  {
    return own;
  }
  const auto all = this->gather(std::vector<char>(own.begin(), own.end()));
  const auto first = std::find_if(
    all.begin(), all.end(), [](const std::vector<char>& text) { return !text.empty(); });
  return std::string(first->begin(), first->end()) + " (on rank " +
    std::to_string(first - all.begin()) + ")";
}

std::vector<char> Ranks::gatherBytes(
  const char* own, std::size_t size, std::vector<std::size_t>& ends) const
{
  const auto length = static_cast<vtkIdType>(size);
  std::vector<vtkIdType> lengths(static_cast<std::size_t>(this->Count));
  this->Controller->AllGather(&length, lengths.data(), 1);
  std::vector<vtkIdType> offsets;
  vtkIdType total = 0;
  for (const vtkIdType each : lengths)
  {
    offsets.push_back(total);
    total += each;
    ends.push_back(static_cast<std::size_t>(total));
  }
  // The size is at least 1, so that data() is not null.
  std::vector<char> all(static_cast<std::size_t>(total) + 1);
  const char nothing = 0;
  this->Controller->AllGatherV(
    own ? own : &nothing, all.data(), length, lengths.data(), offsets.data());
  return all;
}

std::vector<vtkSmartPointer<vtkPolyData>> Ranks::send(vtkPolyData* own, int to) const
{
  if (this->areAlone())
  {
    return { own };
  }
  std::vector<vtkSmartPointer<vtkDataObject>> received;
  this->Controller->Gather(own, received, to);
  std::vector<vtkSmartPointer<vtkPolyData>> pieces;
  for (std::size_t rank = 0; this->Own == to && rank < received.size(); ++rank)
  {
    pieces.emplace_back(vtkPolyData::SafeDownCast(received[rank]));
  }
  return pieces;
}

void Ranks::spread(vtkPolyData* body, int from) const
{
  if (!this->areAlone())
  {
    this->Controller->Broadcast(body, from);
  }
}
} // namespace palpate
