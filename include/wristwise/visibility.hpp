#pragma once

/// What a namespace marked with this declares can be used from outside the shared library.
#define WRISTWISE_PUBLIC [[gnu::visibility("default")]]
