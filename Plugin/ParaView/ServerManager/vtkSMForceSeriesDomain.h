// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMForceSeriesDomain
 * @brief the columns that a chart of forces shows at first, and their style
 *
 * Unlike with vtkSMChartSeriesSelectionDomain, initially only forces are shown, which are columns
 * whose names end with `(N)`. With default_mode="value", readings get the value of the attribute
 * `measured_value`, for points instead of a line. Readings are columns whose names contain `
 * measured`.
 */
#ifndef vtkSMForceSeriesDomain_h
#define vtkSMForceSeriesDomain_h

#include "palpateServerManagerModule.h" // For export macro
#include "vtkSMChartSeriesSelectionDomain.h"

#include <string> // For std::string
#include <vector> // For std::vector

class PALPATESERVERMANAGER_EXPORT vtkSMForceSeriesDomain : public vtkSMChartSeriesSelectionDomain
{
public:
  static vtkSMForceSeriesDomain* New();
  vtkTypeMacro(vtkSMForceSeriesDomain, vtkSMChartSeriesSelectionDomain);

protected:
  vtkSMForceSeriesDomain() = default;
  ~vtkSMForceSeriesDomain() override = default;
  int ReadXMLAttributes(vtkSMProperty* property, vtkPVXMLElement* element) override;
  bool GetDefaultSeriesVisibility(const char* series) override;
  std::vector<std::string> GetDefaultValue(const char* series) override;

private:
  vtkSMForceSeriesDomain(const vtkSMForceSeriesDomain&) = delete;
  void operator=(const vtkSMForceSeriesDomain&) = delete;

  /// Value for readings; if empty, readings have the same value as other columns.
  std::string MeasuredValue;
};

#endif
