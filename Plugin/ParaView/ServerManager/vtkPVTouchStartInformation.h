// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPVTouchStartInformation
 * @brief the starting point of a touch on a source's output, found on the server
 *
 * The information is gathered from a source: the place that palpate::findTouchStart finds on its
 * output, for the view of the client and one response. With several ranks it is the place of the
 * first rank that finds one, since Touch does not support a body in pieces.
 */
#ifndef vtkPVTouchStartInformation_h
#define vtkPVTouchStartInformation_h

#include "palpateServerManagerModule.h" // For export macro
#include "vtkPVInformation.h"

#include <memory> // For std::unique_ptr
#include <string> // For std::string

namespace palpate
{
struct Sight;
}

class PALPATESERVERMANAGER_EXPORT vtkPVTouchStartInformation : public vtkPVInformation
{
public:
  static vtkPVTouchStartInformation* New();
  vtkTypeMacro(vtkPVTouchStartInformation, vtkPVInformation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Sets the output port, the response and the view. */
  void Ask(int port, const std::string& responseName, const palpate::Sight& sight);

  /** Whether a place was found, and its position, mm. */
  bool IsFound() const { return this->Found; }
  const double* GetStart() const { return this->Start; }

  void CopyFromObject(vtkObject* source) override;
  void AddInformation(vtkPVInformation* other) override;
  void CopyToStream(vtkClientServerStream* stream) override;
  void CopyFromStream(const vtkClientServerStream* stream) override;
  void CopyParametersToStream(vtkMultiProcessStream& stream) override;
  void CopyParametersFromStream(vtkMultiProcessStream& stream) override;

protected:
  vtkPVTouchStartInformation();
  ~vtkPVTouchStartInformation() override;

private:
  vtkPVTouchStartInformation(const vtkPVTouchStartInformation&) = delete;
  void operator=(const vtkPVTouchStartInformation&) = delete;

  int Port = 0;
  std::string ResponseName = "Response";
  std::unique_ptr<palpate::Sight> View;
  bool Found = false;
  double Start[3] = { 0.0, 0.0, 0.0 };
};

#endif
