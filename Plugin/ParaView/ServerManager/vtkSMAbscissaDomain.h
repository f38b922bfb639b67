// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMAbscissaDomain
 * @brief the possible abscissas of a chart of forces: the first column, or a column by its name
 *
 * Unlike vtkSMChartSeriesListDomain, the domain lists the `First column` of
 * vtkForceChartRepresentation before the columns, as the default.
 */
#ifndef vtkSMAbscissaDomain_h
#define vtkSMAbscissaDomain_h

#include "palpateServerManagerModule.h" // For export macro
#include "vtkSMChartSeriesListDomain.h"

#include <string> // For std::string
#include <vector> // For std::vector

class PALPATESERVERMANAGER_EXPORT vtkSMAbscissaDomain : public vtkSMChartSeriesListDomain
{
public:
  static vtkSMAbscissaDomain* New();
  vtkTypeMacro(vtkSMAbscissaDomain, vtkSMChartSeriesListDomain);

  int SetDefaultValues(vtkSMProperty* property, bool use_unchecked_values) override;

protected:
  vtkSMAbscissaDomain() = default;
  ~vtkSMAbscissaDomain() override = default;
  void PopulateArrayComponents(
    vtkPVArrayInformation* array, std::vector<std::string>& names) override;

private:
  vtkSMAbscissaDomain(const vtkSMAbscissaDomain&) = delete;
  void operator=(const vtkSMAbscissaDomain&) = delete;
};

#endif
