#include "cook/roles/word_table.h"

#include <algorithm>
#include <map>

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

// Without marks on letters, and without what is another word in English, as French "main".
constexpr Row kOtherLanguages[] = {
    // French
    {Word::pelvis, "bassin"},
    {Word::hip, "hanche hanches"},
    {Word::leg, "jambe"},
    {Word::thigh, "cuisse"},
    {Word::knee, "genou"},
    {Word::ankle, "cheville"},
    {Word::foot, "pied sabot"},
    {Word::toe, "orteil orteils"},
    {Word::spine, "colonne torse"},
    {Word::chest, "poitrine"},
    {Word::neck, "cou"},
    {Word::head, "tete"},
    {Word::jaw, "machoire"},
    {Word::eye, "oeil"},
    {Word::collar, "clavicule omoplate"},
    {Word::shoulder, "epaule"},
    {Word::arm, "bras"},
    {Word::elbow, "coude"},
    {Word::wrist, "poignet"},
    {Word::finger, "doigt"},
    {Word::thumb, "pouce"},
    {Word::tail, "queue"},
    {Word::root, "racine"},
    {Word::other, "museau oreille cheveux"},
    // German
    {Word::pelvis, "becken"},
    {Word::hip, "huefte"},
    {Word::upper, "ober"},
    {Word::lower, "unter"},
    {Word::leg, "bein"},
    {Word::thigh, "oberschenkel"},
    {Word::shin, "unterschenkel"},
    {Word::knee, "knie"},
    {Word::ankle, "knoechel"},
    {Word::foot, "fuss pfote huf"},
    {Word::toe, "zehe zehen"},
    {Word::spine, "wirbel wirbelsaeule"},
    {Word::chest, "brustkorb"},
    {Word::neck, "hals"},
    {Word::head, "kopf"},
    {Word::jaw, "kiefer unterkiefer"},
    {Word::eye, "auge"},
    {Word::collar, "schluesselbein"},
    {Word::shoulder, "schulter"},
    {Word::elbow, "ellbogen ellenbogen"},
    {Word::wrist, "handgelenk"},
    {Word::thumb, "daumen"},
    {Word::tail, "schwanz"},
    {Word::root, "wurzel"},
    // Spanish
    {Word::hip, "cadera caderas"},
    {Word::leg, "pierna"},
    {Word::thigh, "muslo"},
    {Word::shin, "pantorrilla"},
    {Word::knee, "rodilla"},
    {Word::ankle, "tobillo"},
    {Word::foot, "pie"},
    {Word::spine, "columna"},
    {Word::chest, "pecho"},
    {Word::neck, "cuello"},
    {Word::head, "cabeza"},
    {Word::jaw, "mandibula"},
    {Word::eye, "ojo"},
    {Word::collar, "clavicula"},
    {Word::shoulder, "hombro"},
    {Word::arm, "brazo"},
    {Word::forearm, "antebrazo"},
    {Word::elbow, "codo"},
    {Word::wrist, "muneca"},
    {Word::hand, "mano"},
    {Word::finger, "dedo"},
    {Word::thumb, "pulgar"},
    {Word::tail, "cola"},
    {Word::root, "raiz"},
    // Italian
    {Word::pelvis, "bacino"},
    {Word::hip, "anca"},
    {Word::leg, "gamba"},
    {Word::thigh, "coscia"},
    {Word::knee, "ginocchio"},
    {Word::ankle, "caviglia"},
    {Word::foot, "piede"},
    {Word::spine, "colonna"},
    {Word::chest, "petto torace"},
    {Word::neck, "collo"},
    {Word::head, "testa"},
    {Word::jaw, "mandibola mascella"},
    {Word::eye, "occhio"},
    {Word::shoulder, "spalla"},
    {Word::arm, "braccio"},
    {Word::forearm, "avambraccio"},
    {Word::elbow, "gomito"},
    {Word::wrist, "polso"},
    {Word::finger, "dito"},
    {Word::thumb, "pollice"},
    {Word::tail, "coda"},
    {Word::root, "radice"},
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

}  // namespace

std::optional<Word> known_word(std::string_view text) {
  static const std::map<std::string_view, Word> table = read_table();
  const auto found = table.find(text);
  return found == table.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace marrow::cook
