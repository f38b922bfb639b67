// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPVTouchStartInformation
 * @brief the starting point of a touch on a source's output, found on the server
 *
 * The information is gathered from a source. It is the point that palpate::findTouchStart finds on
 * the output of the source, for the view of the client and one response. With several ranks it is
 * the point of the first rank that finds one, because Touch does not support a body that consists
 * of pieces.
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

  /** Sets the output port, the response and the view for the search. */
  void Ask(int port, const std::string& responseName, const palpate::Sight& sight);

  /** Whether a starting point was found. The second function returns its position, mm. */
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
