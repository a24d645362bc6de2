package org.phrenic.ui.window;

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
        LEFT(288),
        RIGHT(368),
        BOTTOM(228);

        private final int size;

        Place(int size) {
            this.size = size;
        }
    }

    private static final int DIVIDER_SIZE = 5;
    private static final int PICTURE_WIDTH = 392;
    private static final int MIN_VIEW_SIZE = 280;
    private static final double BOTTOM_SHARE = 0.32;

    private final transient WindowPreferences preferences;
    private final JSplitPane left = new JSplitPane(JSplitPane.HORIZONTAL_SPLIT);
    private final JSplitPane right = new JSplitPane(JSplitPane.HORIZONTAL_SPLIT);
    private final JSplitPane bottom = new JSplitPane(JSplitPane.VERTICAL_SPLIT);
    private final transient Map<Place, Integer> sizes = new EnumMap<>(Place.class);
    private String keys = "";
    private boolean laidOut;
    /** Whether the docks of another workspace are being set. */
    private boolean changing;

    DockLayout(WindowPreferences preferences, JComponent view) {
        super(new BorderLayout());
        this.preferences = preferences;
        view.setMinimumSize(new Dimension(MIN_VIEW_SIZE, MIN_VIEW_SIZE / 2));
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
            sizes.put(place, place.size);
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
            int usual = workspace == Workspace.CLINICIAN && place == Place.LEFT ? PICTURE_WIDTH : place.size;
            sizes.put(place, preferences.number(keys + place.name(), usual));
        }
        changing = true;
    }

    /** The docks of a workspace are set. */
    void endChange() {
        changing = false;
    }

    /** Sets the dock of a place; null hides the place. */
    void setDock(Place place, JComponent dock) {
        if (laidOut && dock(place) != null && !changing) {
            sizes.put(place, size(place));
        }
        if (dock != null) {
            dock.setMinimumSize(new Dimension(120, 90));
        }
        if (place == Place.LEFT) {
            left.setLeftComponent(dock);
        } else {
            splitPane(place).setRightComponent(dock);
        }
        splitPane(place).setDividerSize(dock == null ? 0 : DIVIDER_SIZE);
        if (laidOut) {
            applySizes();
        }
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
        super.doLayout();
        if (!laidOut && getWidth() > 0) {
            laidOut = true;
            applySizes();
        }
    }

    /** Height of the plots: as it was left, or a share of a high window. */
    private int bottomSize() {
        int size = sizes.get(Place.BOTTOM);
        return size == Place.BOTTOM.size ? Math.max(size, (int) (BOTTOM_SHARE * getHeight())) : size;
    }

    private void applySizes() {
        validate();
        if (dock(Place.BOTTOM) != null) {
            int size = bottomSize() + DIVIDER_SIZE;
            bottom.setDividerLocation(Math.max(MIN_VIEW_SIZE / 2, getHeight() - size));
        }
        if (dock(Place.LEFT) != null) {
            left.setDividerLocation(sizes.get(Place.LEFT));
        }
        bottom.validate();
        if (dock(Place.RIGHT) != null) {
            right.setDividerLocation(Math.max(MIN_VIEW_SIZE, right.getWidth() - DIVIDER_SIZE - sizes.get(Place.RIGHT)));
        }
        revalidate();
    }

    void saveSizes() {
        if (keys.isEmpty()) {
            return;
        }
        for (Place place : Place.values()) {
            int size = dock(place) != null && laidOut ? size(place) : sizes.get(place);
            preferences.setNumber(keys + place.name(), size);
        }
    }
}
