// What users of the shared library may call. All that is not marked stays inside it.
#pragma once

#define SIGHTLINE_EXPORT [[gnu::visibility("default")]]
