// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkToolFilter
 * @brief base class of the filters that press a tool
 *
 * This abstract class has the tool and the name of its response.
 *
 * @code{.py}
 * response = palpate.vtkToolContactResponse()          # is a vtkToolFilter
 * response.SetTool(tool)
 * response.SetResponseName("Sphere")                   # the arrays SphereForce, SphereStiffness...
 * @endcode
 *
 * @sa vtkTissueFilter
 */
#ifndef vtkToolFilter_h
#define vtkToolFilter_h

#include "palpateResponseModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <string> // For std::string

class vtkContactTool;

class PALPATERESPONSE_EXPORT vtkToolFilter : public vtkPolyDataAlgorithm
{
public:
  vtkTypeMacro(vtkToolFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The tool. A change of the tool changes the modification time of this filter. Filters that
   * create a response require a tool. Other filters use by default the tool that the response
   * names.
   */
  virtual void SetTool(vtkContactTool* tool);
  vtkContactTool* GetTool();
  ///@}

  ///@{
  /** Prefix of the response arrays. Use a different prefix for each tool on one body. Default
   * "Response". */
  vtkSetMacro(ResponseName, std::string);
  vtkGetMacro(ResponseName, std::string);
  ///@}

  vtkMTimeType GetMTime() override;

protected:
  vtkToolFilter();
  ~vtkToolFilter() override;

  /// Reports a fault as an error. Returns the result of RequestData: 0 after a fault, else 1.
  int Report(const std::string& fault);

  vtkSmartPointer<vtkContactTool> Tool;
  std::string ResponseName = "Response";

private:
  vtkToolFilter(const vtkToolFilter&) = delete;
  void operator=(const vtkToolFilter&) = delete;
};

#endif
