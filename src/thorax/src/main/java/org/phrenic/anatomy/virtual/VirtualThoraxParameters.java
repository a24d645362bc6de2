package org.phrenic.anatomy.virtual;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.List;
import org.phrenic.document.Key;
import org.phrenic.document.YamlDocument;
import org.phrenic.file.BadInputException;

/**
 * The measures a virtual thorax is generated from, at end-expiration. Lengths in mm, angles in degrees, volumes in ml;
 * arrays run from the first rib or from T1 down. The files in {@code data/thorax} say where each number comes from.
 *
 * @param name what the body is called
 */
public record VirtualThoraxParameters(
        String name,
        Spine spine,
        ChestWall chestWall,
        Ribs ribs,
        Cartilages cartilages,
        Sternum sternum,
        Diaphragm diaphragm,
        Lungs lungs,
        Liver liver,
        Skin skin) {

    /** T1 to L3. */
    public static final int VERTEBRAE = 15;

    private static final String FOLDER = "/org/phrenic/data/thorax/";

    /**
     * The measures that come with the program.
     *
     * @param preset {@code adult-male} or {@code adult-female}
     * @throws IllegalArgumentException if there is no such body
     */
    public static VirtualThoraxParameters preset(String preset) {
        String file = preset + ".yaml";
        try (InputStream in = VirtualThoraxParameters.class.getResourceAsStream(FOLDER + file)) {
            if (in == null) {
                throw new IllegalArgumentException(
                        "virtual thorax '" + preset + "' is not known, expected adult-male or adult-female");
            }
            return YamlDocument.read(file, in).bind(VirtualThoraxParameters.class);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /**
     * Measures from a YAML text; unknown keys, missing keys and wrong counts are errors.
     *
     * @param source what to call the text in messages
     * @throws BadInputException with one sentence naming source, line and key if the text is no full set of measures
     */
    public static VirtualThoraxParameters read(String source, String text) {
        return YamlDocument.parse(source, text).bind(VirtualThoraxParameters.class);
    }

    /**
     * The column T1 to L3.
     *
     * @param kyphosisRadiusMm radius of the thoracic curve
     * @param kyphosisApexMm path from the disc T12/L1 up to where the spine stands upright
     * @param apexYMm y of the bodies' middle there
     * @param lordosisRadiusMm radius of the lumbar curve
     * @param bodyHeightMm heights of the bodies T1-L3
     * @param bodyWidthMm breadths of the bodies T1-L3
     * @param bodyDepthMm depths of the bodies T1-L3
     * @param discHeightMm heights of the discs T1/T2 to L2/L3
     * @param transverseReachMm from the midplane to the tip of the transverse process, T1-L3
     * @param transverseBackMm from the back of the body to the middle of that tip, T1-L3
     * @param spinousLengthMm length of the free spinous process, T1-L3
     * @param spinousDropDeg how far it points down, T1-L3
     */
    public record Spine(
            double kyphosisRadiusMm,
            double kyphosisApexMm,
            double apexYMm,
            double lordosisRadiusMm,
            @Key(count = VERTEBRAE) ImmutableDoubleArray bodyHeightMm,
            @Key(count = VERTEBRAE) ImmutableDoubleArray bodyWidthMm,
            @Key(count = VERTEBRAE) ImmutableDoubleArray bodyDepthMm,
            @Key(count = VERTEBRAE - 1) ImmutableDoubleArray discHeightMm,
            @Key(count = VERTEBRAE) ImmutableDoubleArray transverseReachMm,
            @Key(count = VERTEBRAE) ImmutableDoubleArray transverseBackMm,
            @Key(count = VERTEBRAE) ImmutableDoubleArray spinousLengthMm,
            @Key(count = VERTEBRAE) ImmutableDoubleArray spinousDropDeg) {}

    /**
     * The inner surface of the chest wall.
     *
     * @param axisFraction where the axis stands between spine (0) and front wall (1)
     * @param exponentFront exponent of the section's front half (2: ellipse)
     * @param exponentBack exponent of its back half
     * @param leftBreadthFactor left half-breadth over right
     * @param sections rows of height z, half-breadth, y of the front, y of the back, width of the gutter's slope in
     *     degrees; from below upward
     */
    public record ChestWall(
            double axisFraction,
            double exponentFront,
            double exponentBack,
            double leftBreadthFactor,
            @Key(count = 5) List<ImmutableDoubleArray> sections) {
        public ChestWall {
            requireRising("sections", sections);
        }
    }

    /**
     * The twelve pairs of ribs.
     *
     * @param arcMm length along the rib, ribs 1-12
     * @param pumpDeg how far the rib falls from back to front
     * @param bucketDeg how far it falls from the middle to the side
     * @param leftArcFactor left length over right
     * @param heightMm height of the section at mid-length
     * @param thicknessMm its thickness
     */
    public record Ribs(
            @Key(count = 12) ImmutableDoubleArray arcMm,
            @Key(count = 12) ImmutableDoubleArray pumpDeg,
            @Key(count = 12) ImmutableDoubleArray bucketDeg,
            double leftArcFactor,
            double heightMm,
            double thicknessMm) {}

    /**
     * The costal cartilages.
     *
     * @param joinFraction where along the cartilage above it the end of cartilages 8, 9 and 10 lies (0 at the rib, 1 at
     *     the other end)
     * @param heightMm height of the section
     * @param thicknessMm its thickness
     */
    public record Cartilages(@Key(count = 3) ImmutableDoubleArray joinFraction, double heightMm, double thicknessMm) {}

    /**
     * The sternum.
     *
     * @param manubriumMm length from the jugular notch to the sternal angle
     * @param bodyMm length from there to the xiphisternal joint
     * @param xiphoidMm length of the xiphoid
     * @param angleDeg angle between manubrium and body, seen from behind
     * @param bodyLeanDeg how far the body's upper end leans back
     * @param jointY y of the xiphisternal joint (middle of the bone)
     * @param jointLevel vertebra at whose middle the joint lies (T1 = 1)
     * @param thicknessMm thickness of the body
     * @param notchFraction where cartilages 1-7 meet it: path from the notch over the length of manubrium and body
     */
    public record Sternum(
            double manubriumMm,
            double bodyMm,
            double xiphoidMm,
            double angleDeg,
            double bodyLeanDeg,
            @Key("joint_y_mm") double jointY,
            int jointLevel,
            double thicknessMm,
            @Key(count = 7) ImmutableDoubleArray notchFraction) {}

    /**
     * The diaphragm.
     *
     * @param right dome: x, y, z of its top
     * @param left the same of the left dome
     * @param heart the same of the plateau under the heart
     * @param domeRadiusXMm radius of the domes' curve from side to side
     * @param domeRadiusYMm radius from back to front
     * @param heartRadiusXMm radius of the plateau from side to side
     * @param heartRadiusYMm radius from back to front
     * @param blendMm height over which domes and plateau flow together
     * @param turnRadiusMm radius of the turn from dome to zone of apposition, at the sides and back
     * @param midlineTurnRadiusMm the same at the sternum and the spine
     * @param gapMm from the inner chest wall to the thoracic face in the zone of apposition
     * @param muscleMm thickness of the sheet
     * @param tendonMm thickness of the central tendon
     * @param tendonAreaCm2 area of the central tendon
     * @param rim azimuth in degrees (0 back, positive left) and height z of points of the line of insertion, from -180
     *     to 180
     */
    public record Diaphragm(
            @Key(value = "right_dome_mm", count = 3) ImmutableDoubleArray right,
            @Key(value = "left_dome_mm", count = 3) ImmutableDoubleArray left,
            @Key(value = "heart_plateau_mm", count = 3) ImmutableDoubleArray heart,
            double domeRadiusXMm,
            double domeRadiusYMm,
            double heartRadiusXMm,
            double heartRadiusYMm,
            double blendMm,
            double turnRadiusMm,
            double midlineTurnRadiusMm,
            double gapMm,
            double muscleMm,
            double tendonMm,
            double tendonAreaCm2,
            @Key(count = 2) List<ImmutableDoubleArray> rim) {
        public Diaphragm {
            requireRising("rim", rim);
        }
    }

    /**
     * The lungs and the space for the heart.
     *
     * @param wallInsetMm from the inner chest wall to the lung
     * @param diaphragmGapMm from the diaphragm to the lung's base
     * @param apexRight x, y, z of the right apex
     * @param apexLeft x, y, z of the left apex
     * @param apexRadiusMm radius of its curve
     * @param baseRight x and y of the middle of the right base
     * @param baseLeft x and y of the middle of the left base
     * @param mediastinumMm from the midplane to the right and left lung above the heart
     * @param heartMm from the midplane to the right and left lung beside the heart
     * @param heartCentre y and z of the heart's middle
     * @param heartRadiiMm over which its bulge fades to the back and upward
     * @param heartFrontShare share of the bulge that reaches the front wall, right and left
     */
    public record Lungs(
            double wallInsetMm,
            double diaphragmGapMm,
            @Key(value = "apex_right_mm", count = 3) ImmutableDoubleArray apexRight,
            @Key(value = "apex_left_mm", count = 3) ImmutableDoubleArray apexLeft,
            double apexRadiusMm,
            @Key(value = "base_right_mm", count = 2) ImmutableDoubleArray baseRight,
            @Key(value = "base_left_mm", count = 2) ImmutableDoubleArray baseLeft,
            @Key(count = 2) ImmutableDoubleArray mediastinumMm,
            @Key(count = 2) ImmutableDoubleArray heartMm,
            @Key(value = "heart_centre_mm", count = 2) ImmutableDoubleArray heartCentre,
            @Key(count = 2) ImmutableDoubleArray heartRadiiMm,
            @Key(count = 2) ImmutableDoubleArray heartFrontShare) {}

    /**
     * The liver.
     *
     * @param volumeMl volume
     * @param diaphragmGapMm from the abdominal face of the diaphragm to the liver
     * @param visceralSlope rise of the lower surface: to the left and to the back
     * @param backCut the plane that ends the left lobe behind: y at the midplane, and how much it comes forward per mm
     *     to the left
     * @param leftEndX x of the tip of the left lobe
     */
    public record Liver(
            double volumeMl,
            double diaphragmGapMm,
            @Key(count = 2) ImmutableDoubleArray visceralSlope,
            @Key(count = 2) ImmutableDoubleArray backCut,
            @Key("left_end_x_mm") double leftEndX) {}

    /**
     * The skin of the trunk.
     *
     * @param exponent exponent of the section
     * @param sections rows of height z, half-breadth, y of the front, y of the back; from below upward
     */
    public record Skin(double exponent, @Key(count = 4) List<ImmutableDoubleArray> sections) {
        public Skin {
            requireRising("sections", sections);
        }
    }

    private static void requireRising(String key, List<ImmutableDoubleArray> rows) {
        if (rows.size() < 2) {
            throw new IllegalArgumentException(key + ": found " + rows.size() + " rows, expected at least two");
        }
        for (int i = 1; i < rows.size(); i++) {
            if (!(rows.get(i).at(0) > rows.get(i - 1).at(0))) {
                throw new IllegalArgumentException(
                        key + ": found row " + (i + 1) + " not above the row before, expected rising first numbers");
            }
        }
    }
}
