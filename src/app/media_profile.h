/* murk media --profile: a measured profile as a grid. */
#ifndef MURK_APP_MEDIA_PROFILE_H
#define MURK_APP_MEDIA_PROFILE_H

#include "app/options.h"

murk_command_run murk_command_media_profile;

#endif
