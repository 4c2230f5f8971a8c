#include "cook/options/option_lists.h"

#include "deform/weights/auto_weights.h"
#include "deform/weights/edit_weights.h"

namespace marrow::cook {
namespace {

constexpr Named<std::optional<deform::WeightMethod>> kWeightMethods[] = {{"none", std::nullopt},
                                                                         {"geodesic", deform::WeightMethod::geodesic},
                                                                         {"glow", deform::WeightMethod::glow},
                                                                         {"gaussian", deform::WeightMethod::gaussian},
                                                                         {"nearest", deform::WeightMethod::nearest}};

void set_auto_weights(CookOptions& options, const Value& given) {
  options.prepare.weights.make_origin = given.origin;
  options.prepare.weights.make = *value_of(kWeightMethods, given.text);
}

void set_rebind(CookOptions& options, const Value&) {
  options.prepare.weights.rebind = true;
}

void set_smooth_weights(CookOptions& options, const Value& given) {
  options.prepare.weights.smooth_steps = whole_number(given, 0, deform::kMostSmoothSteps);
  options.prepare.weights.smooth_origin = given.origin;
}

// "JOINT=MASK.png", divided at the last "=", or a file of weights, "hero.paint.json".
void set_paint(CookOptions& options, const Value& given) {
  if (given.text.ends_with(".json")) {
    options.prepare.weights.paint.push_back({"", given.text, given.origin});
    return;
  }
  const std::size_t divide = given.text.rfind('=');
  if (divide == std::string::npos || divide == 0 || divide + 1 == given.text.size())
    refuse(given, "\"" + given.text + "\" names no joint or no mask",
           "give JOINT=MASK.png, as in head=head.png, or what `marrow view --paint` saves, FILE.json");
  options.prepare.weights.paint.push_back({given.text.substr(0, divide), given.text.substr(divide + 1), given.origin});
}

// "CHANNEL=FROM,TO", and behind a comma a count of splines or a radius.
void set_weights_over_time(CookOptions& options, const Value& given) {
  const auto fail = [&](const std::string& why) {
    refuse(given, "\"" + given.text + "\" " + why,
           "give CHANNEL=FROM,TO or CHANNEL=FROM,TO,BASIS, as in swell=arm,biceps,8cm");
  };
  const std::size_t divide = given.text.find('=');
  if (divide == std::string::npos || divide == 0) fail("names no channel");
  std::vector<std::string> parts;
  for (std::size_t begin = divide + 1, end = 0; end != std::string::npos; begin = end + 1) {
    end = given.text.find(',', begin);
    parts.push_back(given.text.substr(begin, end == std::string::npos ? end : end - begin));
  }
  if (parts.size() < 2 || parts.size() > 3 || parts[0].empty() || parts[1].empty()) fail("does not name two joints");
  WeightsOverTime rule{given.text.substr(0, divide), parts[0], parts[1], 1, 0, given.origin};
  if (parts.size() == 3) {
    Amount radius;
    if (!parts[2].empty() && parts[2].find_first_not_of("0123456789") == std::string::npos) {
      rule.splines = whole_number({parts[2], given.origin}, 1, kMostWeightSplines);
    } else if (read_amount(parts[2], radius) && !radius.is_share) {
      rule.radius_m = radius.value;
    } else {
      fail("has neither a count of splines nor a radius behind the joints");
    }
  }
  options.prepare.weights_over_time.push_back(std::move(rule));
}

constexpr Option kWeightOptions[] = {
    {"auto-skeleton",
     OptionKind::text,
     "TEMPLATE",
     "a skeleton for meshes without, or in place of the file's, bound as --auto-weights says: humanoid, quadruped, or "
     "a "
     "TEMPLATE.toml; none: the file's own",
     {},
     [](CookOptions& options, const Value& value) {
       if (value.text.empty()) refuse(value, "no template", "give humanoid, quadruped or a TEMPLATE.toml");
       options.prepare.auto_skeleton = value.text == "none" ? "" : value.text;
     }},
    {"auto-weights", OptionKind::text, "TEXT",
     "skin weights for meshes that come without; geodesic: by the way to the bones through the mesh, which is "
     "recommended; glow: by the light of bones that shine within the mesh; gaussian and nearest: straight through the "
     "air",
     names_in<kWeightMethods>, set_auto_weights},
    {"rebind", OptionKind::flag, "", "with --auto-weights: the file's own skin weights are replaced", {}, set_rebind},
    {"smooth-weights",
     OptionKind::text,
     "STEPS",
     "even out skin weights over the surface, those of the file too, in so many Laplacian steps",
     {},
     set_smooth_weights},
    {"paint",
     OptionKind::list,
     "JOINT=MASK.png",
     "a joint's weight from a grey-scale picture, read at the UVs, white for 1; other joints share what is left; or "
     "FILE.json, what marrow view --paint saves; repeatable",
     {},
     set_paint},
    {"weights-over-time",
     OptionKind::list,
     "CHANNEL=FROM,TO[,BASIS]",
     "the weights of the joint FROM go over to the joint TO as CHANNEL, a number that clips move, goes from 0 to 1; "
     "BASIS: a count of splines over the distance from FROM, each with a number of its own, or a radius round TO, as "
     "8cm; repeatable",
     {},
     set_weights_over_time},
};

}  // namespace

std::span<const Option> weight_options() {
  return kWeightOptions;
}

}  // namespace marrow::cook
