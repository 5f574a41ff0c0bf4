/* Packs requests to the program murk-netcdf, and unpacks them there. */
#include "medium/netcdf_request.h"

void murk_netcdf_pack(murk_parcel *to, const void *context)
{
    const murk_netcdf_request *r = context;
    murk_parcel_put_text(to, r->path);
    murk_parcel_put_text(to, r->where);
    murk_parcel_put_text(to, r->asked.liquid_water);
    murk_parcel_put_text(to, r->asked.effective_radius);
    murk_parcel_put_text(to, r->asked.variable);
    murk_parcel_put(to, &r->asked, sizeof r->asked);
    if (r->asked.law.n > 0) {
        const size_t bytes = r->asked.law.n * sizeof *r->asked.law.value;
        murk_parcel_put(to, r->asked.law.value, bytes);
        murk_parcel_put(to, r->asked.law.density, bytes);
    }
}

murk_status murk_netcdf_unpack(murk_netcdf_request *out, murk_parcel *from,
                               murk_error *err)
{
    murk_netcdf_request r = {.path = murk_parcel_take_text(from),
                             .where = murk_parcel_take_text(from)};
    const char *liquid_water = murk_parcel_take_text(from),
               *effective_radius = murk_parcel_take_text(from),
               *variable = murk_parcel_take_text(from);
    const murk_netcdf_asked *asked = murk_parcel_take(from, sizeof *asked);
    if (from->is_short || !r.path || !r.where || !asked) {
        return murk_fail(err, MURK_RUN_FAILED, "", "malformed request");
    }
    r.asked = *asked;
    /* The points of a law follow the struct. */
    if (asked->law.n > 0) {
        const size_t bytes = asked->law.n * sizeof *asked->law.value;
        r.asked.law.value = murk_parcel_take(from, bytes);
        r.asked.law.density = murk_parcel_take(from, bytes);
        if (from->is_short) {
            return murk_fail(err, MURK_RUN_FAILED, "", "malformed request");
        }
    }
    r.asked.liquid_water = liquid_water;
    r.asked.effective_radius = effective_radius;
    r.asked.variable = variable;
    *out = r;
    return MURK_OK;
}
