/* murk-gdal: reads GeoTIFF files for murk, in a process of its own
 * (terrain/geotiff_request.h). The library starts it; it is of no use by hand.
 */
#include "gdal/ground.h"
#include "gdal/read.h"

#include "base/program.h"

static murk_status read_packed(murk_subprocess *subprocess, murk_parcel *from,
                               murk_error *err)
{
    murk_geotiff_request request;
    const murk_status status = murk_geotiff_unpack(&request, from, err);
    return status ? status : murk_gdal_answer(subprocess, &request, err);
}

int main(void)
{
    static const murk_subprocess_job job = {.name = MURK_GDAL_JOB,
                                            .work_packed = read_packed};
    static const murk_subprocess_job *const jobs[] = {&job};
    murk_parcel request;
    if (!murk_program_request(&request, MURK_GDAL_PROGRAM)) {
        return 2;
    }
    murk_gdal_begin();
    murk_subprocess_serve(&request, MURK_PROGRAM_ANSWER, jobs, 1);
}
