// Users of the shared library may call what has this mark. All that is not marked stays inside it.
#pragma once

#define SIGHTLINE_EXPORT [[gnu::visibility("default")]]
