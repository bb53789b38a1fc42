-- | Views: the original's own examples, and the laws.
module Dioptre.Render.ViewSpec (spec) where

import Data.Foldable (for_)
import qualified Data.Text as Text
import Dioptre.Geometry.Ray (direction, origin)
import Dioptre.Math.Vector (unit, vector)
import Dioptre.Render.View
import Dioptre.Scene.Camera
import Laws.View
import Linear.V3 (V3 (..))
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)

spec :: Spec
spec = do
  -- Camera at the origin, looking along x, z up, 60 degrees, near 1: the picture's edges are tan 30 = 1/sqrt 3 away
  -- from its middle.
  describe "the view of 4 x 4 pixels" $ do
    it "has its corner where the original has it" $ at 4 4 0 0 `shouldBe` Just (V3 1 0.5773502691896257 0.5773502691896257)
    it "has its middle between pixels" $ at 4 4 2 2 `shouldBe` Just (V3 1 0 0)
    it "has its other corner on the other side" $ at 4 4 4 4 `shouldBe` Just (V3 1 (-0.5773502691896257) (-0.5773502691896257))
  describe "the view of an odd number of pixels" $
    for_ [1, 3, 5, 7, 9, 499, 501] $ \n ->
      it ("has its middle in the middle of a pixel: " ++ show n) $ at n n (fromIntegral n / 2) (fromIntegral n / 2) `shouldBe` Just (V3 1 0 0)
  -- Across the picture c is 0.1 and u1 is not 0: 0.1 - tan 30 is rounded.
  it "has its middle beside c by a rounding, where c + r0 is rounded" $
    case (camera (CameraSettings (V3 0 0.1 0) (V3 1 0.1 0) (V3 0 0 1) 60 1 50), viewport 4 4 Text.empty) of
      (Right c, Right v) -> let V3 x y z = pointAt (view c v) 2 2 in (x, y == 0.1, abs (y - 0.1) < 2 ^^ (-53 :: Int), z) `shouldBe` (1, False, True, 0)
      _ -> expectationFailure "no camera"
  describe "the ray through a point" $ do
    it "starts there, on the near plane" $ fmap (\v -> origin (rayThrough v 1 3)) (through 4 4) `shouldBe` at 4 4 1 3
    it "goes on from the eye" $ fmap (\v -> Just (direction (rayThrough v 0 0))) (through 4 4) `shouldBe` Just (vector <$> unit (V3 1 0.5773502691896257 0.5773502691896257))
  it "has the viewport's width and sees as far as the camera" $ fmap (\v -> (viewWidth v, viewFar v)) (through 6 4) `shouldBe` Just (6, 50)

  modifyMaxSuccess (* 4) $
    describe "as laws" $ do
      prop "rays come from the eye, and are unit" raysComeFromTheEye
      prop "rays start on the near clipping plane" raysStartOnTheNearPlane
      prop "the middle of the picture is straight ahead" centreIsAhead
      prop "the middle of the picture is at c, to the bit where nothing is rounded" middleIsTheCentre
      prop "pixels are square" pixelsAreSquare
      prop "right is right and down is down" rightIsRightAndDownIsDown
      prop "the picture is as high as the camera's angle" anglesAreTheCameras
      prop "what a ray goes through is seen where it comes from" projectionIsTheWayBack
  where
    through w h = case (camera (CameraSettings 0 (V3 5 0 0) (V3 0 0 1) 60 1 50), viewport w h Text.empty) of
      (Right c, Right v) -> Just (view c v)
      _ -> Nothing
    at w h x y = (\v -> pointAt v x y) <$> through w h
