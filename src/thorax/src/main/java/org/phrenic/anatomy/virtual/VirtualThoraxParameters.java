package org.phrenic.anatomy.virtual;

import java.util.List;
import java.util.Set;
import org.phrenic.anatomy.virtual.organ.OrganParameters;
import org.phrenic.anatomy.virtual.shape.ImmutableDoubleArray;
import org.phrenic.document.Key;
import org.phrenic.document.ShippedFile;

/**
 * Measures from which a parametric thorax is generated, at end-expiration. Lengths are in mm, angles in degrees,
 * volumes in ml. Arrays are ordered from cranial to caudal, starting at rib 1 or T1. The files in {@code data/thorax}
 * give the source of each number.
 *
 * @param name name of the body
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
        Skin skin,
        Organs organs) {

    private static final Set<String> PRESETS = Set.of("adult-male", "adult-female", "high-colon-male");

    /** Number of vertebrae, T1 to L3. */
    public static final int VERTEBRAE = 15;

    /**
     * Returns a built-in set of measures.
     *
     * @param preset {@code adult-male}, {@code adult-female} or {@code high-colon-male}
     * @throws IllegalArgumentException if there is no preset of this name
     */
    public static VirtualThoraxParameters preset(String preset) {
        if (!PRESETS.contains(preset)) {
            throw new IllegalArgumentException("virtual thorax '" + preset
                    + "' is not known, expected adult-male, adult-female or high-colon-male");
        }
        return ShippedFile.yaml("thorax/" + preset + ".yaml").bind(VirtualThoraxParameters.class);
    }

    /**
     * The vertebral column, T1 to L3.
     *
     * @param kyphosisRadiusMm radius of the thoracic curve
     * @param kyphosisApexMm path from the disc T12/L1 up to the point where the spine is vertical
     * @param apexYMm y of the centre of the vertebral bodies at that point
     * @param lordosisRadiusMm radius of the lumbar curve
     * @param bodyHeightMm heights of the bodies T1-L3
     * @param bodyWidthMm widths of the bodies T1-L3
     * @param bodyDepthMm depths of the bodies T1-L3
     * @param discHeightMm heights of the discs T1/T2 to L2/L3
     * @param transverseReachMm distance from the midplane to the tip of the transverse process, T1-L3
     * @param transverseBackMm distance from the back of the body to the centre of that tip, T1-L3
     * @param spinousLengthMm length of the free part of the spinous process, T1-L3
     * @param spinousDropDeg downward inclination of the spinous process, T1-L3
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
     * @param axisFraction position of the axis between spine (0) and front wall (1)
     * @param exponentFront superellipse exponent of the front half of a section (2: ellipse)
     * @param exponentBack superellipse exponent of the back half
     * @param leftBreadthFactor ratio of left to right half-breadth
     * @param sections rows of height z, half-breadth, y of the front, y of the back, and angular width in degrees of
     *     the slope of the paravertebral gutter; ordered from below upward
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
     * @param pumpDeg descent angle from back to front
     * @param bucketDeg descent angle from the middle to the side
     * @param leftArcFactor ratio of left to right length
     * @param heightMm height of the cross-section at mid-length
     * @param thicknessMm thickness of the cross-section
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
     * @param joinFraction position along the cartilage above at which cartilages 8, 9 and 10 end (0 at the rib, 1 at
     *     the other end)
     * @param heightMm height of the cross-section
     * @param thicknessMm thickness of the cross-section
     */
    public record Cartilages(@Key(count = 3) ImmutableDoubleArray joinFraction, double heightMm, double thicknessMm) {}

    /**
     * The sternum.
     *
     * @param manubriumMm length from the jugular notch to the sternal angle
     * @param bodyMm length from the sternal angle to the xiphisternal joint
     * @param xiphoidMm length of the xiphoid
     * @param angleDeg angle between manubrium and body, measured on the posterior side
     * @param bodyLeanDeg backward tilt of the body's upper end
     * @param jointY y of the xiphisternal joint (middle of the bone)
     * @param jointLevel vertebra whose centre is level with the joint (T1 = 1)
     * @param thicknessMm thickness of the body
     * @param notchFraction attachments of cartilages 1-7: path from the jugular notch over the length of manubrium plus
     *     body
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
     * @param right x, y, z of the top of the right dome
     * @param left x, y, z of the top of the left dome
     * @param heart x, y, z of the top of the plateau under the heart
     * @param domeRadiusXMm radius of curvature of the domes from side to side
     * @param domeRadiusYMm radius of curvature of the domes from back to front
     * @param heartRadiusXMm radius of curvature of the plateau from side to side
     * @param heartRadiusYMm radius of curvature of the plateau from back to front
     * @param blendMm height over which domes and plateau blend
     * @param turnRadiusMm radius of the transition from dome to zone of apposition, at the sides and back
     * @param midlineTurnRadiusMm radius of that transition at the sternum and the spine
     * @param gapMm distance from the inner chest wall to the thoracic face in the zone of apposition
     * @param muscleMm thickness of the muscular part
     * @param tendonMm thickness of the central tendon
     * @param tendonAreaCm2 area of the central tendon
     * @param normalSmoothingMm length over which normals are averaged before the faces are offset from the middle
     *     surface
     * @param cruralRadiusMm radius of curvature below which the sheet is smoothed near the crura
     * @param cruralSmoothingMm length over which it is smoothed there
     * @param rim points of the line of insertion: azimuth in degrees (0 back, positive left) and height z, from -180 to
     *     180
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
            double normalSmoothingMm,
            double cruralRadiusMm,
            double cruralSmoothingMm,
            @Key(count = 2) List<ImmutableDoubleArray> rim) {
        public Diaphragm {
            requireRising("rim", rim);
        }
    }

    /**
     * The lungs and the space for the heart.
     *
     * @param wallInsetMm distance from the inner chest wall to the lung
     * @param diaphragmGapMm distance from the diaphragm to the base of the lung
     * @param apexRight x, y, z of the right apex
     * @param apexLeft x, y, z of the left apex
     * @param apexRadiusMm radius of curvature of the apex
     * @param baseRight x and y of the centre of the right base
     * @param baseLeft x and y of the centre of the left base
     * @param mediastinumMm distance from the midplane to the right and left lung above the heart
     * @param heartMm distance from the midplane to the right and left lung beside the heart
     * @param heartCentre y and z of the centre of the heart
     * @param heartRadiiMm lengths over which the cardiac bulge fades backward and upward
     * @param heartFrontShare fraction of the bulge that reaches the front wall, right and left
     * @param relaxationSweeps sweeps that even out the triangles
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
            @Key(count = 2) ImmutableDoubleArray heartFrontShare,
            int relaxationSweeps) {

        /** These measures with another distance from the inner chest wall. */
        Lungs withWallInset(double insetMm) {
            return new Lungs(
                    insetMm,
                    diaphragmGapMm,
                    apexRight,
                    apexLeft,
                    apexRadiusMm,
                    baseRight,
                    baseLeft,
                    mediastinumMm,
                    heartMm,
                    heartCentre,
                    heartRadiiMm,
                    heartFrontShare,
                    relaxationSweeps);
        }
    }

    /**
     * The liver.
     *
     * @param volumeMl volume
     * @param diaphragmGapMm distance from the abdominal face of the diaphragm to the liver
     * @param visceralSlope rise of the visceral surface to the left and to the back
     * @param backCut plane that bounds the left lobe behind: y at the midplane, and forward shift per mm to the left
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
     * @param exponent superellipse exponent of the cross-section
     * @param sections rows of height z, half-breadth, y of the front, y of the back; ordered from below upward
     */
    public record Skin(double exponent, @Key(count = 4) List<ImmutableDoubleArray> sections) {
        public Skin {
            requireRising("sections", sections);
        }
    }

    /**
     * Organs and vessels that no model of breathing needs.
     *
     * @param gapMm distance between neighbouring organs
     * @param pleuraInsetMm distance from the inner chest wall to the parietal pleura
     * @param pleuralReflection points of the line where the pleura turns from the chest wall to the diaphragm: azimuth
     *     in degrees (0 back, positive left) and height z, from -180 to 180
     * @param internalMammary points of the internal mammary vessels behind the costal cartilages: height z and distance
     *     from the midplane, ordered from below upward
     * @param superiorEpigastric points of the superior epigastric vessels behind the rectus muscle, as those
     * @param parts organs and vessels; each leaves room for those before it
     */
    public record Organs(
            @Key(min = 0.1, max = 5) double gapMm,
            @Key(above = 0, max = 5) double pleuraInsetMm,
            @Key(count = 2) List<ImmutableDoubleArray> pleuralReflection,
            @Key(count = 2) List<ImmutableDoubleArray> internalMammary,
            @Key(count = 2) List<ImmutableDoubleArray> superiorEpigastric,
            List<OrganParameters> parts) {
        public Organs {
            requireRising("pleural_reflection", pleuralReflection);
            requireRising("internal_mammary", internalMammary);
            requireRising("superior_epigastric", superiorEpigastric);
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
