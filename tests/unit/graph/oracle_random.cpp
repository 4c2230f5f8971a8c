// Makes random graphs of behaviour.
#include "unit/graph/oracle_random.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace marrow::test::oracle {
namespace {

// As a float, so that the text has all of it.
std::string text(double value) {
  char out[64];
  std::snprintf(out, sizeof(out), "%.9g", static_cast<double>(static_cast<float>(value)));
  std::string s = out;
  return s.find_first_of(".e") == std::string::npos ? s + ".0" : s;
}
std::string named(const std::string& s) {
  return "\"" + s + "\"";
}

class Writer {
 public:
  Writer(std::uint64_t seed, int height, bool calm) : chance_(seed), height_(height), calm_(calm) {}
  std::string write() {
    const std::string output = big(height_);
    std::string out = "output = " + named(output) + "\n";
    if (!parameters_.empty()) out += "[parameters]\n" + parameters_;
    return out + nodes_;
  }

 private:
  enum class Sort { clip, in_step, other, nothing };
  struct Target {
    std::string name;
    std::string pose;
    Sort sort = Sort::other;
    bool waits = false;  // its clip plays once, as at_end asks for its end
  };

  std::string fresh(const char* with) { return with + std::to_string(count_++); }
  std::string ground_clip() {
    static const char* const all[] = {"idle", "walk", "run", "turn", "attack", "jump"};
    return all[chance_.below(6)];
  }
  std::string number(double least, double most) {
    const std::string name = fresh("p");
    parameters_ += name + " = { type = \"number\", range = [" + text(least) + ", " + text(most) + "]";
    if (chance_.is(0.5)) parameters_ += ", initial = " + text(chance_.number(least, most));
    if (chance_.is(0.7)) parameters_ += ", half_life = " + text(chance_.number(0.02, 0.4));
    parameters_ += " }\n";
    numbers_.push_back({name, least, most});
    return name;
  }
  std::string flag() {
    const std::string name = fresh("f");
    parameters_ += name + " = { type = \"flag\", initial = " + (chance_.is(0.5) ? "true" : "false") + " }\n";
    return name;
  }
  std::string trigger() {
    if (!calm_ && !triggers_.empty() && chance_.is(0.15)) return triggers_[chance_.below(triggers_.size())];
    const std::string name = fresh("t");
    triggers_.push_back(name);
    parameters_ += name + " = { type = \"trigger\"";
    if (chance_.is(0.6) || calm_) parameters_ += ", hold = " + text(chance_.number(0.02, 0.5));
    parameters_ += " }\n";
    return name;
  }
  void node(const std::string& name, const std::string& body) { nodes_ += "[node." + name + "]\n" + body; }

  // A pose of any kind.
  std::string any(int height) {
    if (!calm_ && !done_.empty() && chance_.is(0.1)) return done_[chance_.below(done_.size())];
    const std::string name = height <= 0 || chance_.is(0.15) ? leaf() : big(height);
    if (name[0] == 'n') done_.push_back(name);  // another may take it, too
    return name;
  }
  std::string leaf() {
    if (chance_.is(0.5)) return ground_clip();
    const std::string name = fresh("n");
    if (chance_.is(0.08)) {
      node(name, "type = \"given\"\n");
      return name;
    }
    static const char* const plays[] = {"", "play = \"loop\"\n", "play = \"once\"\n", "play = \"ping_pong\"\n"};
    const double speed = chance_.is(0.05) ? 0 : chance_.is(0.2) ? chance_.number(-1.5, -0.3) : chance_.number(0.3, 2);
    node(name, "type = \"clip\"\nclip = " + named(ground_clip()) + "\nspeed = " + text(speed) + "\n" +
                   plays[chance_.below(4)]);
    return name;
  }
  std::string big(int height) {
    const double which = chance_.number();
    if (height <= 0) return leaf();
    if (which < 0.2) return space(height);
    if (which < 0.3) return in_step();
    if (which < 0.6 && (!calm_ || height == height_)) return machine(height, false);
    if (which < 0.6) return in_step();
    if (which < 0.75) return layer(height);
    if (which < 0.82) return additive(height);
    if (which < 0.92) return one_shot(height);
    return calm_ && height < height_ ? in_step() : pick();
  }

  std::string in_step() {
    const std::string name = fresh("n");
    std::string body = "type = \"space\"\nsync = true\n";
    if (chance_.is(0.5)) {
      // By their speeds.
      static const char* const all[] = {"idle", "attack", "turn", "walk", "run"};
      const double up_to[] = {0, 0.3 / 0.8, 1 / 1.5, 1.2, 4};
      std::string points;
      std::size_t from = chance_.below(3), count = 0;
      double most = 0;
      for (; from < 5; from += 1 + chance_.below(2), ++count) {
        points += std::string(points.empty() ? "" : ", ") + "{ pose = " + named(all[from]) + " }";
        most = up_to[from];
      }
      body += "by = " + named(number(0, most * 1.3 + 0.5)) + "\npoints = [" + points + "]\n";
      if (chance_.is(0.8)) body += "match_speed = true\n";
    } else if (chance_.is(0.5)) {
      body += on_line(1 + chance_.below(4), [&] { return ground_clip(); });
    } else {
      body += on_plane([&] { return ground_clip(); });
    }
    node(name, body);
    return name;
  }
  template <class Make>
  std::string on_line(std::size_t count, const Make& make) {
    double at = chance_.number(-2, 0);
    const double first = at;
    std::string points;
    for (std::size_t i = 0; i < count; ++i, at += chance_.number(0.2, 1.5))
      points += std::string(i > 0 ? ", " : "") + "{ at = " + text(at) + ", pose = " + named(make()) + " }";
    return "by = " + named(number(first - 0.3, at)) + "\npoints = [" + points + "]\n";
  }
  template <class Make>
  std::string on_plane(const Make& make) {
    std::string points = "{ at = [0.02, -0.03], pose = " + named(make()) + " }";
    const std::size_t count = 3 + chance_.below(3);
    for (std::size_t i = 0; i < count; ++i) {
      const double angle = (static_cast<double>(i) + chance_.number(-0.3, 0.3)) * 6.2832 / static_cast<double>(count);
      const double far = chance_.number(0.7, 1.3);
      points += ", { at = [" + text(far * std::cos(angle)) + ", " + text(far * std::sin(angle)) +
                "], pose = " + named(make()) + " }";
    }
    const std::string x = number(-1.5, 1.4), y = number(-1.3, 1.5);
    return "by = [" + named(x) + ", " + named(y) + "]\npoints = [" + points + "]\n";
  }
  std::string space(int height) {
    const std::string name = fresh("n");
    const auto make = [&] { return any(height - 1); };
    const std::string body = chance_.is(0.7) ? on_line(1 + chance_.below(4), make) : on_plane(make);
    node(name, "type = \"space\"\n" + body);
    return name;
  }

  std::string mask() {
    static const char* const joints[] = {"hips", "spine", "chest", "head", "left_arm", "right_arm"};
    const auto part = [&] {
      std::string out = "{ joint = " + named(joints[chance_.below(6)]);
      if (chance_.is(0.5)) out += ", falloff = " + std::to_string(chance_.below(4));
      return out + " }";
    };
    if (chance_.is(0.3)) return "";
    return "mask = " + (chance_.is(0.7) ? part() : "[" + part() + ", " + part() + "]") + "\n";
  }
  std::string weight() {
    const double which = chance_.number();
    if (which < 0.2) return "weight = " + text(chance_.number()) + "\n";
    if (which < 0.5) return "weight = " + named(number(-0.2, 1.3)) + "\n";
    if (which < 0.9) return "weight = " + named(flag()) + "\nfade = " + text(chance_.number(0.05, 0.6)) + "\n";
    return "";
  }
  std::string layer(int height) {
    const std::string name = fresh("n"), base = any(height - 1);
    std::string pose = chance_.is(0.3) && !calm_ ? machine(height - 1, true) : any(height - 1);
    if (chance_.is(0.15) && base[0] == 'n') pose = base;  // one node
    node(name, "type = \"layer\"\nbase = " + named(base) + "\npose = " + named(pose) + "\n" + mask() + weight() +
                   (chance_.is(0.3) ? "space = \"model\"\n" : ""));
    return name;
  }
  std::string additive(int height) {
    const std::string name = fresh("n"), base = any(height - 1);
    node(name, "type = \"add\"\nbase = " + named(base) + "\npose = \"lean\"\n" + mask() + weight());
    return name;
  }
  std::string one_shot(int height) {
    const std::string name = fresh("n"), base = any(height - 1);
    std::string body = "type = \"one_shot\"\nbase = " + named(base) + "\npose = " + named(ground_clip()) +
                       "\nwhen = " + named(trigger()) + "\n" + mask();
    if (chance_.is(0.5)) body += "fade_in = " + text(chance_.number(0.01, 0.3)) + "\n";
    if (chance_.is(0.5)) body += "fade_out = " + text(chance_.number(0.01, 0.3)) + "\n";
    node(name, body);
    return name;
  }
  std::string choose() { return chance_.is(0.5) ? "choose = \"turn\"" : "choose = \"chance\""; }
  std::string pick() {
    const std::string name = fresh("n");
    std::string poses;
    for (std::size_t i = 0, count = 1 + chance_.below(4); i < count; ++i)
      poses += (i > 0 ? ", " : "") + named(ground_clip());
    std::string body = "type = \"pick\"\nposes = [" + poses + "]\n" + choose() + "\n";
    if (chance_.is(0.5)) body += "fade = " + text(chance_.number(0.05, 0.25)) + "\n";
    node(name, body);
    return name;
  }

  Target state(int height, bool may_be_nothing) {
    Target out;
    out.name = fresh("s");
    const double which = chance_.number();
    if (may_be_nothing && which < 0.3) {
      out.sort = Sort::nothing;
    } else if (which < 0.5) {
      out.sort = Sort::clip;
      out.pose = ground_clip();
      out.waits = chance_.is(0.5);
    } else if (which < 0.7) {
      out.sort = Sort::in_step;
      out.pose = height > 0 ? in_step() : ground_clip();
    } else {
      out.pose = any(height - 1);
    }
    return out;
  }
  std::string condition() {
    if (chance_.is(0.5)) return named((chance_.is(0.5) ? "not " : "") + flag());
    if (numbers_.empty() || chance_.is(0.3)) number(0, 1);
    const Number& n = numbers_[chance_.below(numbers_.size())];
    static const char* const tests[] = {" > ", " < ", " >= ", " <= "};
    return named(n.name + tests[chance_.below(4)] + text(chance_.number(n.least, n.most)));
  }
  std::string transition(const std::vector<Target>& all, std::size_t from, bool any_state) {
    std::size_t to = chance_.below(all.size());
    if (to == from && (calm_ || !chance_.is(0.1))) to = (to + 1) % all.size();
    std::string out = "  { from = " + named(any_state ? "*" : all[from].name);
    if (!any_state && chance_.is(0.2) && to + 1 < all.size() && !(calm_ && to + 1 == from))
      out += ", to = [" + named(all[to].name) + ", " + named(all[to + 1].name) + "], " + choose();
    else
      out += ", to = " + named(all[to].name);
    const double which = chance_.number();
    if (!any_state && all[from].waits && which < 0.6) {
      out += ", at_end = " + text(chance_.number(0.03, 0.4));
      if (chance_.is(0.2)) out += ", when = " + condition();
      if (calm_) out += ", after = 0.7";
    } else if (which < 0.7) {
      out += ", when = " + named(trigger());
      if (calm_)
        out += ", after = " + text(chance_.number(0.65, 1));
      else if (chance_.is(0.2))
        out += ", after = " + text(chance_.number(0.05, 0.5));
    } else {
      if (chance_.is(0.6))
        out += ", when = " + (chance_.is(0.7) ? condition() : "[" + condition() + ", " + condition() + "]");
      out += ", after = " + text(chance_.number(calm_ ? 0.65 : 0.1, 3));
    }
    out += ", fade = " + (chance_.is(0.15) ? "0" : text(chance_.number(0.03, 0.6)));
    if (chance_.is(0.5)) out += chance_.is(0.5) ? ", kind = \"inertial\"" : ", kind = \"cross\"";
    const auto has_phase = [](const Target& t) {
      return !t.waits && (t.sort == Sort::clip || t.sort == Sort::in_step);
    };
    if (!any_state && has_phase(all[from]) && has_phase(all[to]) && to != from && out.find("[") == std::string::npos &&
        chance_.is(0.5))
      out += ", enter = \"same_phase\"";
    else if (all[to].sort == Sort::clip && out.find("to = [") == std::string::npos && chance_.is(0.3))
      out += ", enter = " + text(chance_.number(0, 0.5));
    return out + " },\n";
  }
  std::string machine(int height, bool may_be_nothing) {
    const std::string name = fresh("n");
    std::vector<Target> all;
    for (std::size_t i = 0, count = 2 + chance_.below(4); i < count; ++i) all.push_back(state(height, may_be_nothing));
    std::string transitions;
    if (chance_.is(0.3)) transitions += transition(all, all.size(), true);
    for (std::size_t s = 0; s < all.size(); ++s)
      for (std::size_t i = 0, count = 1 + chance_.below(2); i < count; ++i) transitions += transition(all, s, false);
    std::string body = "type = \"machine\"\nstart = " + named(all[0].name) + "\n";
    for (const Target& t : all)
      body += "state." + t.name + " = {" + (t.pose.empty() ? "" : " pose = " + named(t.pose)) + " }\n";
    node(name, body + "transition = [\n" + transitions + "]\n");
    return name;
  }

  struct Number {
    std::string name;
    double least, most;
  };
  Chance chance_;
  int height_, count_ = 0;
  bool calm_;
  std::string parameters_, nodes_;
  std::vector<std::string> triggers_, done_;
  std::vector<Number> numbers_;
};

}  // namespace

std::string random_graph(std::uint64_t seed, int height, bool calm) {
  return Writer(seed, height, calm).write();
}

std::vector<Input> random_inputs(const Graph& graph, Chance& chance, double dt_s) {
  std::vector<Input> out;
  for (std::size_t p = 0; p < graph.parameters.size(); ++p) {
    const Parameter& parameter = graph.parameters[p];
    const double a_second = parameter.kind == ParameterKind::trigger ? 1 : 0.5;
    if (!chance.is(std::min(0.5, a_second * (dt_s + 0.001)))) continue;
    switch (parameter.kind) {
      case ParameterKind::number: {
        const double past = 0.1 * (parameter.most - parameter.least);
        const float value = static_cast<float>(chance.number(parameter.least - past, parameter.most + past));
        out.push_back({p, static_cast<double>(value)});
        break;
      }
      case ParameterKind::flag:
        out.push_back({p, chance.is(0.5) ? 1.0 : 0.0});
        break;
      case ParameterKind::trigger:
        out.push_back({p, 1});
        break;
    }
  }
  return out;
}

}  // namespace marrow::test::oracle
