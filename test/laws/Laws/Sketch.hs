-- |
-- Module      : Laws.Sketch
-- Description : Scenes as text, and a second ray tracer
--
-- A sketch is a small scene that knows two ways to its picture: as a text in the scene language, which the program
-- reads and renders; and by a second ray tracer, which is written here from the textbooks, shares nothing with the
-- program but the meaning of the words, and does without vectors, units, roots and prepared shapes. It is simple and
-- slow, and it knows when its answer hangs on rounding.
module Laws.Sketch
  ( Sketch (..),
    Thing (..),
    sketchText,
    sketchScene,
    Answer (..),
    answer,
    sketchColour,
  )
where

import Data.List (sortOn)
import Data.Text (Text)
import qualified Data.Text as Text
import Dioptre.Scene (Scene)
import Dioptre.Scene.Check (checkScene)
import Dioptre.Source.Text (fromText)
import Dioptre.Syntax.Grammar (parse)
import Test.QuickCheck

type Triple = (Double, Double, Double)

-- | A shape by its numbers.
data Thing
  = Flat Triple Triple
  | Round Triple Triple Double
  | Ring Triple Triple Double Double
  | Ball Triple Double
  | Die Triple Double
  | Corner Triple Triple Triple
  | Bent Triple Triple Triple
  deriving (Eq, Show)

-- | A scene: where the eye is, what it looks at and what is up; the vertical angle, near and far; width and height;
-- samples, the name of the pixel coordinate, and the seed; things with the names of their paints, and paints (name,
-- colour and kd). If it is lit, the text has lights and mirrors, which the second ray tracer knows nothing about.
data Sketch = Sketch
  { sketchEye :: Triple,
    sketchLookAt :: Triple,
    sketchUp :: Triple,
    sketchLens :: Triple,
    sketchSize :: (Int, Int),
    sketchSamples :: Int,
    sketchCoordinate :: String,
    sketchSeed :: Int,
    sketchNormalization :: String,
    sketchIsLit :: Bool,
    sketchThings :: [(String, Thing)],
    sketchPaints :: [(String, Triple, Double)]
  }
  deriving (Eq, Show)

instance Arbitrary Sketch where
  arbitrary = do
    eye <- (,,) <$> elements [-9, -8.3] <*> tenth 30 <*> tenth 30
    lookAt <- (,,) <$> tenth 10 <*> tenth 10 <*> tenth 10
    up <- elements [(0, 0, 1), (0, 1, 0), (0.1, -1, 2)]
    lens <- (,,) <$> elements [30, 60, 95] <*> elements [0.5, 1, 6] <*> elements [9.5, 12, 100]
    size <- (,) <$> chooseInt (1, 9) <*> chooseInt (1, 9)
    samples <- elements [1, 1, 2, 3]
    coordinate <- elements ["top_left", "top_right", "bottom_left", "bottom_right", "center", "random", "random"]
    seed <- chooseInt (0, 1000000)
    normalization <- elements ["clamp_channel", "division_factor"]
    things <- chooseInt (0, 8) >>= \n -> vectorOf n ((,) <$> elements ["a", "b", "c", "d"] <*> thing)
    paints <- vectorOf 5 ((,,) <$> elements ["a", "b", "c", "none"] <*> ((,,) <$> light <*> light <*> light) <*> ((/ 10) . fromIntegral <$> chooseInt (0, 10)))
    pure (Sketch eye lookAt up lens size samples coordinate seed normalization False things paints)
    where
      tenth n = (/ 10) . fromIntegral <$> chooseInt (-n, n)
      light = oneof [elements [0, 1], (/ 16) . fromIntegral <$> chooseInt (0, 48)]
      place = (,,) <$> tenth 30 <*> tenth 30 <*> tenth 30
      across = place `suchThat` (\(x, y, z) -> abs x + abs y + abs z > 1)
      length' = (/ 4) . fromIntegral <$> chooseInt (2, 12)
      corners make = (make <$> place <*> place <*> place) `suchThat` wide
      wide t = case t of
        Corner a b c -> modulus (times (b `minus` a) (c `minus` a)) > 1
        Bent a b c -> modulus (times (b `minus` a) (c `minus` a)) > 1
        _ -> True
      thing =
        oneof
          [ Flat <$> place <*> across,
            Round <$> place <*> across <*> length',
            (\p n r f -> Ring p n r (r * f)) <$> place <*> across <*> length' <*> elements [0, 0.25, 0.5, 1],
            Ball <$> place <*> length',
            Die <$> place <*> length',
            corners Corner,
            corners Bent
          ]
  shrink s = [s {sketchThings = ts} | ts <- shrinkList (const []) (sketchThings s)]

-------------------------------------------------------------------------------
-- As a text

-- | The sketch in the scene language.
sketchText :: Sketch -> Text
sketchText s =
  Text.pack . unlines $
    block "camera" [vec "position" (sketchEye s), vec "look_at" (sketchLookAt s), vec "up" (sketchUp s), num "angle" a, num "near_clipping_plane" near, num "far_clipping_plane" far]
      ++ block "viewport" ["width " ++ show w, "height " ++ show h]
      ++ block
        "raytracer"
        [ "sampling " ++ show (sketchSamples s),
          "pixel_coordinate " ++ sketchCoordinate s,
          "seed " ++ show (sketchSeed s),
          "color_normalization " ++ sketchNormalization s,
          "reflexion_algorithm " ++ (if sketchIsLit s then "blinn" else "no_light"),
          "recursive_level 3"
        ]
      ++ concat [block "primitive" (("material_name " ++ paint) : shape thing) | (paint, thing) <- sketchThings s]
      ++ concat [block "material" ["name " ++ name, vec "color" colour, num "kd" kd, num "kr" (if sketchIsLit s then 0.5 else 0)] | (name, colour, kd) <- sketchPaints s]
      ++ concat [block "point_light" [vec "position" (-9, 3, 20), vec "color" (1, 1, 0.5)] ++ block "ambient_light" [vec "color" (0.5, 0.5, 1)] | sketchIsLit s]
  where
    (a, near, far) = sketchLens s
    (w, h) = sketchSize s
    block word inner = [word] ++ map ("  " ++) inner ++ ["end"]
    num :: String -> Double -> String
    num word x = word ++ " " ++ show x
    vec :: String -> Triple -> String
    vec word v = word ++ " " ++ show3 v
    show3 (x, y, z) = show [x, y, z]
    shape thing = case thing of
      Flat p n -> block "plane" [vec "position" p, vec "normal" n]
      Round p n r -> block "disk" [vec "position" p, vec "normal" n, num "ray" r]
      Ring p n r i -> block "annulus" [vec "position" p, vec "normal" n, num "ray" r, num "inner_ray" i]
      Ball p r -> block "sphere" [vec "position" p, num "ray" r]
      Die p r -> block "cube" [vec "position" p, num "size" r]
      Corner p q r -> block "triangle" (map (vec "point") [p, q, r])
      Bent p q r -> block "btriangle" (map (vec "point") [p, q, r])

-- | The scene that the program makes of it.
sketchScene :: Sketch -> Scene
sketchScene = fst . checkScene . parse . fromText "sketch" . sketchText

-------------------------------------------------------------------------------
-- The second ray tracer

-- | What is seen through a point of the picture.
data Answer
  = Background
  | -- | The thing of that number.
    Thing Int
  | -- | What is seen just beside it differs, or two things are equally near.
    Uncertain
  deriving (Eq, Show)

-- | What is seen through a point of the picture, given in pixels from the top left; uncertain unless the four points
-- a millionth of a pixel away show the same.
answer :: Sketch -> Double -> Double -> Answer
answer s x y = case [look s (x + dx) (y + dy) | (dx, dy) <- [(0, 0), (-e, -e), (-e, e), (e, -e), (e, e)]] of
  first : others | all (== first) others -> first
  _ -> Uncertain
  where
    e = 1e-6

look :: Sketch -> Double -> Double -> Answer
look s x y = case sortOn fst (concat [[(t, i) | t <- ahead thing] | (i, (_, thing)) <- zip [0 ..] (sketchThings s)]) of
  hits | any (\(t, _) -> abs t < margin || abs (t - far) < margin) hits -> Uncertain
  hits -> case filter (\(t, _) -> t > 0 && t < far) hits of
    (t, i) : (t', j) : _ | t' - t < margin && i /= j -> Uncertain
    (_, i) : _ -> Thing i
    [] -> Background
  where
    margin = 1e-9
    (degrees, near, far) = sketchLens s
    (w, h) = sketchSize s
    front = normed (sketchLookAt s `minus` sketchEye s)
    right = normed (times front (sketchUp s))
    upwards = times right front
    half = near * sin (degrees * pi / 360) / cos (degrees * pi / 360)
    -- From -1 to 1 in the height, and as much as the proportions have in the width.
    across = (2 * x - fromIntegral w) / fromIntegral h
    above = 1 - 2 * y / fromIntegral h
    reach = (near .* front) `add` ((half * across) .* right) `add` ((half * above) .* upwards)
    o = sketchEye s `add` reach
    d = normed reach
    ahead thing = case thing of
      Flat p n -> flat p n
      Round p n r -> [t | t <- flat p n, modulus (at t `minus` p) <= r]
      Ring p n r i -> [t | t <- flat p n, let q = modulus (at t `minus` p), i <= q, q <= r]
      -- The point of the line that is nearest to the centre, and half the chord.
      Ball c r ->
        let m = by (c `minus` o) d
            q = c `minus` at m
            chord = r * r - by q q
         in if chord < 0 then [] else [m - sqrt chord, m + sqrt chord]
      -- Six squares.
      Die (cx, cy, cz) size ->
        let k = size / 2
            (ox, oy, oz) = o
            (dx, dy, dz) = d
            face c q v others = [t | v /= 0, side <- [-k, k], let t = (c + side - q) / v, all (\(c', q', v') -> abs (q' + t * v' - c') <= k) others]
         in face cx ox dx [(cy, oy, dy), (cz, oz, dz)] ++ face cy oy dy [(cx, ox, dx), (cz, oz, dz)] ++ face cz oz dz [(cx, ox, dx), (cy, oy, dy)]
      Corner a b c -> inside a b c
      Bent a b c -> inside a b c
    at t = o `add` (t .* d)
    flat p n = [by n (p `minus` o) / by n d | by n d /= 0]
    -- The point of the plane, on the inner side of the three edges.
    inside a b c =
      let n = times (b `minus` a) (c `minus` a)
       in [t | t <- flat a n, let p = at t, all (\(u, v) -> by n (times (v `minus` u) (p `minus` u)) >= 0) [(a, b), (b, c), (c, a)]]

-- | The colour that an answer stands for: kd times the colour of the first paint of the thing's paint's name; of the
-- grey that stands in for a missing one, 0.6 of white.
sketchColour :: Sketch -> Answer -> Maybe (Rational, Rational, Rational)
sketchColour s a = case a of
  Uncertain -> Nothing
  Background -> Just (0, 0, 0)
  Thing i -> case [(colour, kd) | (name, colour, kd) <- sketchPaints s, name == fst (sketchThings s !! i)] of
    ((r, g, b), kd) : _ -> Just (times' kd r, times' kd g, times' kd b)
    [] -> Just (toRational (0.6 :: Double), toRational (0.6 :: Double), toRational (0.6 :: Double))
  where
    times' x y = toRational x * toRational y

-- * Triples

minus, add, times :: Triple -> Triple -> Triple
minus (a, b, c) (x, y, z) = (a - x, b - y, c - z)
add (a, b, c) (x, y, z) = (a + x, b + y, c + z)
times (a, b, c) (x, y, z) = (b * z - c * y, c * x - a * z, a * y - b * x)

(.*) :: Double -> Triple -> Triple
k .* (x, y, z) = (k * x, k * y, k * z)

by :: Triple -> Triple -> Double
by (a, b, c) (x, y, z) = a * x + b * y + c * z

modulus :: Triple -> Double
modulus v = sqrt (by v v)

normed :: Triple -> Triple
normed v = (1 / modulus v) .* v
