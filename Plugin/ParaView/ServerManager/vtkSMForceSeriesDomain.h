// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMForceSeriesDomain
 * @brief the columns that a chart of forces shows at first, and their style
 *
 * It works as vtkSMChartSeriesSelectionDomain, but at first only forces are shown: columns whose
 * names end with `(N)`. With default_mode="value", readings get the value of the attribute
 * `measured_value`: points instead of a line. The names of readings contain ` measured`.
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

  std::string MeasuredValue; ///< value for readings; empty: the same value as for other columns
};

#endif
