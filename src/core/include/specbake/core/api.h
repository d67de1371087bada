#pragma once

/// What a shared library of specbake exports; everything else in it is its own.
#define SPECBAKE_API __attribute__((visibility("default")))
/// A part of something exported that is the library's own all the same.
#define SPECBAKE_LOCAL __attribute__((visibility("hidden")))
