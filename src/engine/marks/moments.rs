//! Area, centroid and second moments of polygons and what they add up to.

/// Area, first and second moments of a region of the plane.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Moments {
    /// ∫1, px².
    pub area: f64,
    /// ∫x, px³.
    pub x: f64,
    /// ∫y, px³.
    pub y: f64,
    /// ∫x², px⁴.
    pub xx: f64,
    /// ∫xy, px⁴.
    pub xy: f64,
    /// ∫y², px⁴.
    pub yy: f64,
}

impl Moments {
    /// Adds those of another region, which does not overlap this one.
    pub fn add(&mut self, other: &Self) {
        self.area += other.area;
        self.x += other.x;
        self.y += other.y;
        self.xx += other.xx;
        self.xy += other.xy;
        self.yy += other.yy;
    }

    /// The moments of the same region moved by `dx`, `dy`.
    #[must_use]
    pub fn moved(&self, [dx, dy]: [f64; 2]) -> Self {
        Self {
            area: self.area,
            x: self.x + dx * self.area,
            y: self.y + dy * self.area,
            xx: self.xx + dx * (2.0 * self.x + dx * self.area),
            xy: self.xy + dx * self.y + dy * (self.x + dx * self.area),
            yy: self.yy + dy * (2.0 * self.y + dy * self.area),
        }
    }

    /// The moments of the rectangle [x0, x1] × [y0, y1].
    #[must_use]
    pub fn rectangle([x0, x1]: [f64; 2], [y0, y1]: [f64; 2]) -> Self {
        let (w, h) = (x1 - x0, y1 - y0);
        let area = w * h;
        let (x, y) = (0.5 * (x0 + x1), 0.5 * (y0 + y1));
        Self {
            area,
            x: area * x,
            y: area * y,
            xx: area * (x * x + w * w / 12.0),
            xy: area * x * y,
            yy: area * (y * y + h * h / 12.0),
        }
    }

    /// The moments of a polygon, by Green's theorem; positive where its corners go from +x towards +y.
    #[inline(always)]
    #[must_use]
    pub fn polygon(corners: &[[f64; 2]]) -> Self {
        let mut sum = Self::default();
        for (k, [x1, y1]) in corners.iter().enumerate() {
            let [x0, y0] = corners[if k == 0 { corners.len() - 1 } else { k - 1 }];
            let cross = x0 * y1 - x1 * y0;
            sum.area += cross;
            sum.x += cross * (x0 + x1);
            sum.y += cross * (y0 + y1);
            sum.xx += cross * (x0 * x0 + x0 * x1 + x1 * x1);
            sum.xy += cross * (2.0 * (x0 * y0 + x1 * y1) + x0 * y1 + x1 * y0);
            sum.yy += cross * (y0 * y0 + y0 * y1 + y1 * y1);
        }
        Self {
            area: sum.area / 2.0,
            x: sum.x / 6.0,
            y: sum.y / 6.0,
            xx: sum.xx / 12.0,
            xy: sum.xy / 24.0,
            yy: sum.yy / 12.0,
        }
    }

    /// Centroid, and the covariance [xx, xy, yy] about it: the second central moments ÷ the area. Not finite without area.
    #[must_use]
    pub fn central(&self) -> ([f64; 2], [f64; 3]) {
        let [x, y] = [self.x / self.area, self.y / self.area];
        let [xx, xy, yy] = [self.xx, self.xy, self.yy].map(|sum| sum / self.area);
        ([x, y], [xx - x * x, xy - x * y, yy - y * y])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_polygon_and_a_rectangle_have_the_same_moments_wherever_they_lie() {
        let (x, y) = ([3.0, 5.5], [-2.0, -1.0]);
        let polygon = Moments::polygon(&[[3.0, -2.0], [5.5, -2.0], [5.5, -1.0], [3.0, -1.0]]);
        let moved = Moments::rectangle([0.0, 2.5], [0.0, 1.0]).moved([3.0, -2.0]);
        for other in [polygon, moved] {
            let rectangle = Moments::rectangle(x, y);
            let pairs = [
                (rectangle.area, other.area),
                (rectangle.x, other.x),
                (rectangle.y, other.y),
                (rectangle.xx, other.xx),
                (rectangle.xy, other.xy),
                (rectangle.yy, other.yy),
            ];
            assert!(pairs.iter().all(|(a, b)| (a - b).abs() < 1e-12), "{pairs:?}");
        }
    }
}
