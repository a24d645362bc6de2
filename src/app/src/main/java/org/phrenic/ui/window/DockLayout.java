package org.phrenic.ui.window;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.event.ActionEvent;
import java.util.EnumMap;
import java.util.Map;
import javax.swing.AbstractAction;
import javax.swing.Action;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JSplitPane;
import org.phrenic.ui.session.WindowPreferences;
import org.phrenic.ui.session.Workspace;

/** The view in the middle and docks at the left, right and bottom, which can be hidden; keeps their sizes. */
final class DockLayout extends JPanel {
    /** Side of the window that a dock is at. */
    enum Place {
        LEFT(288, 220),
        RIGHT(368, 300),
        BOTTOM(228, 90);

        private final int usual;
        private final int least;

        Place(int usual, int least) {
            this.usual = usual;
            this.least = least;
        }

        int size() {
            return UIScale.scale(usual);
        }

        int minimum() {
            return UIScale.scale(least);
        }
    }

    private static final int DIVIDER_SIZE = 5;
    private static final int PICTURE_WIDTH = 392;
    private static final int MIN_VIEW_SIZE = 260;
    private static final double BOTTOM_SHARE = 0.32;

    private final transient WindowPreferences preferences;
    private final JSplitPane left = new JSplitPane(JSplitPane.HORIZONTAL_SPLIT);
    private final JSplitPane right = new JSplitPane(JSplitPane.HORIZONTAL_SPLIT);
    private final JSplitPane bottom = new JSplitPane(JSplitPane.VERTICAL_SPLIT);
    /** Sizes that the user wants. */
    private final transient Map<Place, Integer> sizes = new EnumMap<>(Place.class);
    /** Sizes that there was room for when the docks were laid out. */
    private final transient Map<Place, Integer> given = new EnumMap<>(Place.class);

    private String keys = "";
    private transient Dimension laidOut = new Dimension();
    /** Whether the docks of another workspace are being set. */
    private boolean changing;

    DockLayout(WindowPreferences preferences, JComponent view) {
        super(new BorderLayout());
        this.preferences = preferences;
        view.setMinimumSize(new Dimension(minViewSize(), minViewSize() / 2));
        right.setLeftComponent(view);
        right.setResizeWeight(1);
        left.setRightComponent(right);
        bottom.setTopComponent(left);
        bottom.setResizeWeight(1);
        for (JSplitPane pane : new JSplitPane[] {left, right, bottom}) {
            pane.setBorder(BorderFactory.createEmptyBorder());
            pane.setContinuousLayout(true);
            moveByArrowsInFocus(pane);
        }
        for (Place place : Place.values()) {
            sizes.put(place, place.size());
        }
        add(bottom);
    }

    /** Lets arrow keys move the divider only where the pane itself has the focus (F8), not a part of a dock. */
    private static void moveByArrowsInFocus(JSplitPane pane) {
        for (String name : new String[] {"negativeIncrement", "positiveIncrement"}) {
            Action usual = pane.getActionMap().get(name);
            pane.getActionMap().put(name, new AbstractAction(name) {
                @Override
                public boolean isEnabled() {
                    return pane.isFocusOwner();
                }

                @Override
                public void actionPerformed(ActionEvent e) {
                    usual.actionPerformed(e);
                }
            });
        }
    }

    /** Takes the sizes that the docks of a workspace had last; pictures need more room than lists. */
    void useSizesOf(Workspace workspace) {
        saveSizes();
        keys = workspace == Workspace.CLINICIAN ? "dock.clinician." : "dock.";
        for (Place place : Place.values()) {
            int usual = workspace == Workspace.CLINICIAN && place == Place.LEFT ? PICTURE_WIDTH : place.usual;
            int wanted = UIScale.scale(preferences.number(keys + place.name(), usual));
            sizes.put(place, Math.max(place.minimum(), wanted));
        }
        changing = true;
    }

    /** The docks of a workspace are set. */
    void endChange() {
        changing = false;
        applySizes();
    }

    /** Sets the dock of a place; null hides the place. */
    void setDock(Place place, JComponent dock) {
        takeMovedDividers();
        if (dock != null) {
            boolean below = place == Place.BOTTOM;
            dock.setMinimumSize(new Dimension(
                    below ? UIScale.scale(120) : place.minimum(), below ? place.minimum() : UIScale.scale(90)));
        }
        if (place == Place.LEFT) {
            left.setLeftComponent(dock);
        } else {
            splitPane(place).setRightComponent(dock);
        }
        splitPane(place).setDividerSize(dock == null ? 0 : DIVIDER_SIZE);
        applySizes();
    }

    /** The dock of a place; null for none. */
    Component dock(Place place) {
        return place == Place.LEFT ? left.getLeftComponent() : splitPane(place).getRightComponent();
    }

    private JSplitPane splitPane(Place place) {
        return place == Place.LEFT ? left : place == Place.RIGHT ? right : bottom;
    }

    private int size(Place place) {
        Component dock = dock(place);
        return place == Place.BOTTOM ? dock.getHeight() : dock.getWidth();
    }

    @Override
    public void doLayout() {
        boolean resized = !getSize().equals(laidOut);
        if (resized) {
            takeMovedDividers();
        }
        super.doLayout();
        if (resized) {
            laidOut = getSize();
            applySizes();
        }
    }

    private static int minViewSize() {
        return UIScale.scale(MIN_VIEW_SIZE);
    }

    /** The look and feel scales the size that a split pane is given. */
    private static int dividerSize() {
        return UIScale.scale(DIVIDER_SIZE);
    }

    /** Takes the sizes of docks whose divider was moved since they were laid out. */
    private void takeMovedDividers() {
        if (changing) {
            return;
        }
        for (Place place : Place.values()) {
            if (dock(place) != null && given.containsKey(place) && given.get(place) != size(place)) {
                sizes.put(place, size(place));
            }
        }
    }

    /** Height of the plots: as it was left, or a share of a high window. */
    private int bottomSize() {
        int size = sizes.get(Place.BOTTOM);
        return size == Place.BOTTOM.size() ? Math.max(size, (int) (BOTTOM_SHARE * getHeight())) : size;
    }

    /** Gives the docks the sizes that are wanted, or those that there is room for beside the view. */
    private void applySizes() {
        if (changing || getWidth() == 0) {
            return;
        }
        validate();
        if (dock(Place.BOTTOM) != null) {
            int size = bottomSize() + dividerSize();
            int above = right.getLeftComponent().getMinimumSize().height;
            bottom.setDividerLocation(Math.max(above, getHeight() - size));
        }
        int room = getWidth() - minViewSize() - 2 * dividerSize();
        int rightWidth = dock(Place.RIGHT) == null ? 0 : sizes.get(Place.RIGHT);
        int leftWidth = dock(Place.LEFT) == null ? 0 : leftWidth(room, sizes.get(Place.LEFT), rightWidth);
        if (dock(Place.LEFT) != null) {
            left.setDividerLocation(leftWidth);
        }
        bottom.validate();
        if (dock(Place.RIGHT) != null) {
            int width = rightWidth(room, leftWidth, rightWidth);
            right.setDividerLocation(Math.max(0, right.getWidth() - dividerSize() - width));
        }
        bottom.validate();
        given.clear();
        for (Place place : Place.values()) {
            if (dock(place) != null) {
                given.put(place, size(place));
            }
        }
        revalidate();
    }

    /** Width of the dock at the left, which gives way first, pixels. */
    static int leftWidth(int room, int wanted, int wantedRight) {
        return Math.max(Place.LEFT.minimum(), Math.min(wanted, room - wantedRight));
    }

    /** Width of the dock at the right beside one at the left, pixels. */
    static int rightWidth(int room, int leftWidth, int wanted) {
        return Math.max(Place.RIGHT.minimum(), Math.min(wanted, room - leftWidth));
    }

    /**
     * Saves the sizes that are wanted, not those that a small window forces, as pixels where letters have their usual
     * size.
     */
    void saveSizes() {
        if (keys.isEmpty()) {
            return;
        }
        takeMovedDividers();
        for (Place place : Place.values()) {
            preferences.setNumber(keys + place.name(), UIScale.unscale(sizes.get(place)));
        }
    }
}
