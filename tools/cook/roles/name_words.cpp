#include "cook/roles/name_words.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

namespace marrow::cook {
namespace {

struct Row {
  Word word;
  std::string_view texts;
};

constexpr Row kEnglish[] = {
    {Word::neutral,
     "bone bones joint joints jnt jt bn skeleton armature rig character mixamorig mixamo bip bipe biped base cc sk "
     "skin j b c f ccbase valve valvebiped def animal bend in of the body rl genesis metarig proximal intermediate "
     "distal phalanx"},
    {Word::upper, "upper up upr uper"},
    {Word::lower, "lower low lwr lo"},
    {Word::front, "front fore"},
    {Word::back, "back hind rear"},
    {Word::mid, "mid"},
    {Word::leg, "leg legs"},
    {Word::thigh, "thigh femur hipleg"},
    {Word::shin, "shin calf tibia crus"},
    {Word::knee, "knee"},
    {Word::ankle, "ankle hock"},
    {Word::foot, "foot feet paw hoof"},
    {Word::toe, "toe toes ball"},
    {Word::hip, "hip hips"},
    {Word::pelvis, "pelvis"},
    {Word::spine, "spine torso abdomen waist abdominal lumbar"},
    {Word::chest, "chest thorax ribcage"},
    {Word::neck, "neck"},
    {Word::head, "head"},
    {Word::jaw, "jaw mandible"},
    {Word::mouth, "mouth"},
    {Word::eye, "eye eyes eyeball"},
    {Word::collar, "clavicle collar scapula collarbone clav"},
    {Word::shoulder, "shoulder shldr shoulders"},
    {Word::arm, "arm arms"},
    {Word::humerus, "humerus"},
    {Word::forearm, "forearm radius ulna"},
    {Word::elbow, "elbow"},
    {Word::wrist, "wrist carpus"},
    {Word::hand, "hand hands fist"},
    {Word::finger, "finger fingers"},
    {Word::thumb, "thumb"},
    {Word::index, "index pointer"},
    {Word::middle, "middle"},
    {Word::ring, "ring"},
    {Word::little, "little pinky pinkie"},
    {Word::palm, "palm metacarpal carpal metacarpals"},
    {Word::tail, "tail"},
    {Word::root, "root master world global origin reference main"},
    {Word::deform, "deform"},
    {Word::mechanism, "org"},
    {Word::twist, "twist roll"},
    {Word::control,
     "ik fk ctrl control controller controls pole target poletarget mch tweak helper drv driver corrective aim "
     "orient pivot vis offset null dummy grp group constraint socket slot attach mount anchor proxy bendy widget"},
    {Word::end, "end tip nub leaf top site effector"},
    {Word::other,
     "wing feather fin flipper ear horn hair bang fringe pony ponytail skirt cape cloak cloth coat dress scarf "
     "breast boob bust butt glute pouch belt bag weapon gun sword shield blade bow lid eyelid brow eyebrow lash "
     "lip "
     "cheek nose nostril tongue teeth tooth beard gill muscle pad armor strap hat hood helmet crown mask belly "
     "stomach tummy heel big hoop chin face snout trunk antenna tentacle claw nail sleeve collider jiggle link "
     "horse bulge pec lat trap biceps bicep triceps glasses backpack chain rope button prop camera light"},
};

// French, German, Spanish and Italian; without marks on letters, and without what is another word in English, as
// French "main".
constexpr Row kOtherLanguages[] = {
    {Word::upper, "ober"},
    {Word::lower, "unter"},
    {Word::leg, "jambe bein pierna gamba"},
    {Word::thigh, "cuisse oberschenkel muslo coscia"},
    {Word::shin, "unterschenkel pantorrilla"},
    {Word::knee, "genou knie rodilla ginocchio"},
    {Word::ankle, "cheville knoechel tobillo caviglia"},
    {Word::foot, "pied sabot fuss pfote huf pie piede"},
    {Word::toe, "orteil orteils zehe zehen"},
    {Word::hip, "hanche hanches huefte cadera caderas anca"},
    {Word::pelvis, "bassin becken bacino"},
    {Word::spine, "colonne torse wirbel wirbelsaeule columna colonna"},
    {Word::chest, "poitrine brustkorb pecho petto torace"},
    {Word::neck, "cou hals cuello collo"},
    {Word::head, "tete kopf cabeza testa"},
    {Word::jaw, "machoire kiefer unterkiefer mandibula mandibola mascella"},
    {Word::eye, "oeil auge ojo occhio"},
    {Word::collar, "clavicule omoplate schluesselbein clavicula"},
    {Word::shoulder, "epaule schulter hombro spalla"},
    {Word::arm, "bras brazo braccio"},
    {Word::forearm, "antebrazo avambraccio"},
    {Word::elbow, "coude ellbogen ellenbogen codo gomito"},
    {Word::wrist, "poignet handgelenk muneca polso"},
    {Word::hand, "mano"},
    {Word::finger, "doigt dedo dito"},
    {Word::thumb, "pouce daumen pulgar pollice"},
    {Word::tail, "queue schwanz cola coda"},
    {Word::root, "racine wurzel raiz radice"},
    {Word::other, "museau oreille cheveux"},
};

std::map<std::string_view, Word> read_table() {
  std::map<std::string_view, Word> out;
  const auto add = [&](const Row& row) {
    for (std::size_t at = 0; at < row.texts.size();) {
      const std::size_t end = std::min(row.texts.find(' ', at), row.texts.size());
      out.emplace(row.texts.substr(at, end - at), row.word);
      at = end + 1;
    }
  };
  std::ranges::for_each(kEnglish, add);
  std::ranges::for_each(kOtherLanguages, add);
  return out;
}

// Of small letters from a to z; nothing: no word that is known.
std::optional<Word> known_word(std::string_view text) {
  static const std::map<std::string_view, Word> table = read_table();
  const auto found = table.find(text);
  return found == table.end() ? std::nullopt : std::optional(found->second);
}

constexpr std::size_t kLongest = 24;  // letters of a run that is taken apart

Side side_of(std::string_view text) {
  for (const std::string_view left : {"l", "left", "lft", "lt", "gauche", "links", "izquierda", "sinistra"})
    if (text == left) return Side::left;
  for (const std::string_view right : {"r", "right", "rgt", "rt", "droite", "rechts", "derecha", "destra"})
    if (text == right) return Side::right;
  return Side::none;
}

Corner corner_of(std::string_view text) {
  for (const auto& [name, corner] : {std::pair{"fl", Corner::front_left},
                                     {"fr", Corner::front_right},
                                     {"hl", Corner::back_left},
                                     {"bl", Corner::back_left},
                                     {"hr", Corner::back_right},
                                     {"br", Corner::back_right}})
    if (text == name) return corner;
  return Corner::none;
}

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

// Takes in words, one after the other.
class WordReader {
 public:
  void add_letters(const std::string& text) {
    if (const Side side = side_of(text); side != Side::none) return add_side(side);
    if (const std::optional<Word> word = known_word(text)) return add(*word);
    if (const Corner corner = corner_of(text); corner != Corner::none) {
      out_.corner = corner;
      return;
    }
    if (text.size() <= kLongest && (add_with_side(text) || add_run(text))) return;
    out_.unknown.push_back(text);
    add(Word::unknown);
  }
  void add_number(std::string_view digits) {
    if (begun_ && digits.size() <= 6) out_.numbers.emplace_back(digits);
  }
  // A side twice is none.
  NameWords finish() {
    if (left_ && right_) add(Word::unknown);
    out_.side = left_ == right_ ? Side::none : left_ ? Side::left : Side::right;
    return std::move(out_);
  }

 private:
  void add(Word word) {
    out_.add(word);
    begun_ |= word != Word::neutral;
  }
  void add_side(Side side) { (side == Side::left ? left_ : right_) = true; }

  // "lefthand", "lthigh", "handl".
  bool add_with_side(const std::string& text) {
    for (const std::string_view side : {"left", "right", "l", "r"}) {
      if (text.size() < side.size() + 3) continue;
      const bool ends_with = text.ends_with(side);
      if (!text.starts_with(side) && !ends_with) continue;
      for (const bool front : {true, false}) {
        if (front ? !text.starts_with(side) : !ends_with) continue;
        const std::string rest = front ? text.substr(side.size()) : text.substr(0, text.size() - side.size());
        const std::optional<Word> word = known_word(rest);
        if (!word && !add_run(rest)) continue;
        if (word) add(*word);
        add_side(side_of(side));
        return true;
      }
    }
    return false;
  }

  // "upperarm": known words one after the other, as few as possible.
  bool add_run(std::string_view text) {
    struct Best {
      std::size_t pieces = SIZE_MAX, from = 0;
    };
    std::array<Best, kLongest + 1> best;
    best[0].pieces = 0;
    for (std::size_t end = 1; end <= text.size(); ++end)
      for (std::size_t from = 0; from + 2 <= end; ++from)
        if (best[from].pieces < 3 && best[from].pieces + 1 < best[end].pieces &&
            known_word(text.substr(from, end - from)))
          best[end] = {best[from].pieces + 1, from};
    if (text.empty() || best[text.size()].pieces > 3) return false;
    for (std::size_t end = text.size(); end > 0; end = best[end].from)
      add(*known_word(text.substr(best[end].from, end - best[end].from)));
    return true;
  }

  NameWords out_;
  bool left_ = false, right_ = false, begun_ = false;
};

}  // namespace

NameWords words_of(std::string_view name) {
  if (const std::size_t colon = name.rfind(':'); colon != std::string_view::npos) name.remove_prefix(colon + 1);
  WordReader reader;
  for (std::size_t at = 0; at < name.size();) {
    std::size_t end = at + 1;
    if (is_digit(name[at])) {
      while (end < name.size() && is_digit(name[end])) ++end;
      reader.add_number(name.substr(at, end - at));
    } else if (is_letter(name[at])) {
      // A word ends before a capital, a run of capitals before its last one if small letters follow.
      if (is_capital(name[at]) && end < name.size() && is_capital(name[end])) {
        while (end < name.size() && is_capital(name[end]) &&
               !(end + 1 < name.size() && is_letter(name[end + 1]) && !is_capital(name[end + 1])))
          ++end;
      } else {
        while (end < name.size() && is_letter(name[end]) && !is_capital(name[end])) ++end;
      }
      std::string small(name.substr(at, end - at));
      for (char& c : small) c = small_letter(c);
      reader.add_letters(small);
    } else if (static_cast<unsigned char>(name[at]) >= 0x80) {
      reader.add_letters("?");
    }
    at = end;
  }
  return reader.finish();
}
}  // namespace marrow::cook
