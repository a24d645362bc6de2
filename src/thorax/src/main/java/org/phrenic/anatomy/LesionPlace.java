package org.phrenic.anatomy;

import java.util.regex.Pattern;

/**
 * Where a lesion lies, by the words of its name in lower case. One whose name holds neither the liver nor another organ
 * nor a bone is one of the liver.
 */
public final class LesionPlace {
    private static final Pattern LESION = Pattern.compile(".*(lesion|tumou?r).*");
    private static final Pattern LIVER = holding("liver");
    private static final Pattern BONE =
            holding("bones?|skelet(on|al)|ribs?|costal|stern(um|al)|vertebra[el]?|spin(e|al)"
                    + "|sacr(um|al)|scapula|clavicle|humerus|femur|hip|pelvis|skull|chest_wall");
    /** Bones that a breath moves, and bones of which the name does not say which. */
    private static final Pattern MOVING_BONE = holding("bones?|skelet(on|al)|ribs?|costal|stern(um|al)|chest_wall");

    private static final Pattern LUNG = Pattern.compile(".*(lung|bronch).*");
    private static final Pattern MEDIASTINUM =
            holding("pulmonary|pleural?|mediastin(um|al)|heart|cardiac|pericardi(um|al)|trachea(l)?|thym(us|ic)");
    private static final Pattern OTHER_ORGAN = holding("o?esophag(us|eal)|thyroid|renal|splenic|adrenals?|gallbladder"
            + "|stomach|gastric|duoden(um|al)|bowel|intestine|colon|colonic|rect(um|al)|bladder|prostate"
            + "|uter(us|ine)|ovar(y|ian)|breast|brain|cord|muscles?|skin|nodes?|lymph(nodes?)?|wall|psoas|aortic"
            + "|ureter(al|ic)?|periton(eum|eal)|oment(um|al)|mesenter(y|ic)|append(ix|iceal)");
    /** Names of organs that a breath does not move, and what a lesion of these is called after. */
    private static final Pattern STILL =
            holding("aort(a|ic)|o?esophag(us|eal)|thyroid|brachiocephalic_[a-z]+|subclavian_[a-z]+"
                    + "|common_carotid_[a-z]+|iliac_[a-z]+|superior_vena_cava|autochthon|(ilio)?psoas"
                    + "|glute(us|al)|muscles?|abdominal_wall");

    private static final Pattern KNOWN = holding(String.join("|", OrganNames.outsideLiver()));
    /** Parts of the names of other organs that no other word holds. */
    private static final Pattern OTHER_STEM = Pattern.compile(".*(kidney|spleen|pancrea|gland).*");

    private LesionPlace() {}

    /** Names of which a word is one of these. */
    private static Pattern holding(String words) {
        return Pattern.compile("(.*_)?(" + words + ")(_.*)?");
    }

    /** Whether it is a lesion of the liver. */
    public static boolean isInLiver(String name) {
        return isLesion(name) && (LIVER.matcher(name).matches() || !isElsewhere(name));
    }

    /** Whether it is a lesion of the lungs or of what lies between them. */
    public static boolean isInChest(String name) {
        return isLesion(name) && !LIVER.matcher(name).matches() && isOfChest(name);
    }

    /** Whether it is a lesion of a bone, a costal cartilage or the chest wall between them. */
    public static boolean isInBone(String name) {
        return isLesion(name)
                && !LIVER.matcher(name).matches()
                && BONE.matcher(name).matches();
    }

    /** Whether it is a lesion of a bone that may be a rib, the sternum or a costal cartilage. */
    public static boolean mayBeInCage(String name) {
        return isInBone(name) && MOVING_BONE.matcher(name).matches();
    }

    /** Whether it is a lesion of an organ that a breath does not move. */
    public static boolean standsStill(String name) {
        return isLesion(name)
                && !LIVER.matcher(name).matches()
                && !isOfChest(name)
                && !BONE.matcher(name).matches()
                && STILL.matcher(name).matches();
    }

    private static boolean isLesion(String name) {
        return LESION.matcher(name).matches();
    }

    private static boolean isOfChest(String name) {
        return LUNG.matcher(name).matches() || MEDIASTINUM.matcher(name).matches();
    }

    private static boolean isElsewhere(String name) {
        return isOfChest(name)
                || BONE.matcher(name).matches()
                || KNOWN.matcher(name).matches()
                || OTHER_ORGAN.matcher(name).matches()
                || OTHER_STEM.matcher(name).matches();
    }
}
