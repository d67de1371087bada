#pragma once

/// Names of CLI11, for headers that speak of them: its own headers take seconds to compile.
namespace CLI {
class App;
class Option;
class Validator;
}  // namespace CLI
